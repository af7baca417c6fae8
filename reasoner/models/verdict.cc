#include "reasoner/models/typical_models.h"

namespace lares::models {

const char* ToString(Verdict verdict) {
  switch (verdict) {
    case Verdict::kLoaded:
      return "loaded";
    case Verdict::kNotTypical:
      return "not-typical";
    case Verdict::kTooRare:
      return "too-rare";
    case Verdict::kRobotLacks:
      return "robot-lacks-algorithm";
    case Verdict::kTooMany:
      return "too-many";
    case Verdict::kTooLarge:
      return "too-large";
  }
  return "";
}

}  // namespace lares::models
