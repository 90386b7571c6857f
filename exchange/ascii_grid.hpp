#pragma once

#include "core/expected.hpp"
#include "exchange/formats/polygons.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace furrow::exchange {

/// The samples of an ESRI ASCII grid in the order of the file, from its north-west. A comma counts
/// as a decimal point.
///
/// Its header are the lines of two words before them that begin with a letter.
/// @error  A word that is no number, with its line, row and column, all from 1; other than
///         `columns` x `rows` numbers.
Expected<std::vector<float>, Fault> ascii_samples(std::string_view bytes, std::size_t columns,
                                                  std::size_t rows);

}  // namespace furrow::exchange
