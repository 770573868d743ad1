#include "acquisition/hits/hits.hpp"

#include <algorithm>

namespace tapfit::acquisition {

void note(Hit& hit, HitFault fault) {
  const bool known =
      std::count(hit.reasons.begin(), hit.reasons.end(), fault) > 0;
  if (!known) hit.reasons.push_back(fault);
}

void reject(Hit& hit, HitFault fault) {
  hit.accepted = false;
  note(hit, fault);
}

std::string name(HitFault fault) {
  switch (fault) {
    case HitFault::Double:
      return "double";
    case HitFault::Overload:
      return "overload";
    case HitFault::Weak:
      return "weak";
    case HitFault::Soft:
      return "soft";
    case HitFault::Truncated:
      return "truncated";
    case HitFault::Outlier:
      return "outlier";
    case HitFault::ByHand:
      return "by hand";
  }
  return {};
}

void overrule(Hit& hit) {
  const auto has = [&](HitFault fault) {
    return std::find(hit.reasons.begin(), hit.reasons.end(), fault);
  };
  if (has(HitFault::Truncated) != hit.reasons.end()) return;
  hit.accepted = !hit.accepted;
  const auto by_hand = has(HitFault::ByHand);
  if (by_hand == hit.reasons.end()) {
    hit.reasons.push_back(HitFault::ByHand);
  } else {
    hit.reasons.erase(by_hand);
  }
}

}  // namespace tapfit::acquisition
