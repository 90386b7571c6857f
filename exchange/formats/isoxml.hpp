#pragma once

#include "exchange/formats/formats.hpp"
#include "exchange/formats/xml_tree.hpp"

namespace furrow::exchange {

/// The part fields of an ISO 11783-10 task, also those of its external files.
std::optional<Fault> read_isoxml(const CPLXMLNode* root, const LandFile& file, Polygons& found);

}  // namespace furrow::exchange
