#pragma once

#include "exchange/formats/formats.hpp"

#include <ogrsf_frmts.h>

#include <memory>
#include <string>

namespace furrow::exchange {

/// A land file open in OGR. It is read from memory: no driver can write beside the user's file.
class OpenLayers {
 public:
  OpenLayers(const LandFile& file, Driver driver);
  ~OpenLayers();
  OpenLayers(const OpenLayers&) = delete;
  OpenLayers& operator=(const OpenLayers&) = delete;

  /// Null if the driver cannot read the file.
  GDALDataset* dataset() const { return dataset_.get(); }

 private:
  static void lay_out(const std::string& path, const std::string& bytes);

  std::string folder_;
  std::unique_ptr<GDALDataset> dataset_;
};

}  // namespace furrow::exchange
