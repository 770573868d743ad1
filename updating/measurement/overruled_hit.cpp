#include "updating/measurement/overruled_hit.hpp"

namespace tapfit::updating {

void add_act(std::vector<OverruledHit>& acts,
             const std::vector<OverruledHit>& hits) {
  bool together = false;
  for (const OverruledHit& h : hits) {
    acts.push_back({h.run, h.hit, together});
    together = true;
  }
}

std::vector<OverruledHit> take_last_act(std::vector<OverruledHit>& acts) {
  std::vector<OverruledHit> hits;
  bool more = !acts.empty();
  while (more) {
    hits.push_back(acts.back());
    acts.pop_back();
    more = hits.back().together && !acts.empty();
  }
  return hits;
}

std::vector<OverruledHit> overruled_now(const std::vector<OverruledHit>& acts) {
  std::vector<OverruledHit> now;
  for (const OverruledHit& act : acts) {
    const OverruledHit alone{act.run, act.hit};
    if (std::erase(now, alone) == 0) now.push_back(alone);
  }
  return now;
}

}  // namespace tapfit::updating
