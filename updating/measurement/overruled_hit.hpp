// Hits whose judgement was overruled by hand, act after act: what was done with
// one key is undone with one.
#pragma once

#include <cstddef>
#include <vector>

namespace tapfit::updating {

/// Counted from 0; in files, as on the screens, from 1.
struct OverruledHit {
  std::size_t run = 0;
  std::size_t hit = 0;
  bool together = false;  ///< in one act with the one before it

  bool operator==(const OverruledHit&) const = default;
};

/// One after the other, the last one last. Overruled twice, a hit is judged as
/// before.
struct HitActs {
  std::vector<OverruledHit> done;
  std::vector<OverruledHit> undone;  ///< for a redo, the next one last
};

/// Puts these hits behind the others, as one act.
void add_act(std::vector<OverruledHit>& acts,
             const std::vector<OverruledHit>& hits);

/// Takes the last act away.
/// @return its hits, the last one first; none where there is no act
[[nodiscard]] std::vector<OverruledHit> take_last_act(
    std::vector<OverruledHit>& acts);

/// The hits that all acts leave overruled, each as if by itself.
[[nodiscard]] std::vector<OverruledHit> overruled_now(
    const std::vector<OverruledHit>& acts);

}  // namespace tapfit::updating
