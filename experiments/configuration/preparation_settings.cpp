#include "shapegauge/experiments/configuration/preparation_settings.h"

namespace shapegauge {

PreparationOptions read_preparation(const nlohmann::json& settings) {
  PreparationOptions preparation;
  preparation.denoise = settings.value("denoise", preparation.denoise);
  if (settings.value("scale", "area") == "tube_area") preparation.scale = ScaleEstimate::tube_area;
  return preparation;
}

nlohmann::json to_json(const PreparationOptions& preparation) {
  return {{"denoise", preparation.denoise}, {"scale", preparation.scale == ScaleEstimate::area ? "area" : "tube_area"}};
}

}  // namespace shapegauge
