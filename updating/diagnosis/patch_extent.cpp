#include "updating/diagnosis/patch_extent.hpp"

#include "updating/fit/estimates.hpp"
#include "updating/places/near_places.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::updating {
namespace {

PatchExtent extent_of(const Hypothesis& h,
                      const effects::TestContext& context) {
  const std::size_t size = h.own().where.elements.size();
  const Estimate factor =
      effect_estimates(h.fit, h.fit.effects.size() - 1, context).front();
  return {size, size, factor.lo95, factor.hi95};
}

void join(const PatchExtent& one, PatchExtent& all) {
  all.fewest = std::min(all.fewest, one.fewest);
  all.most = std::max(all.most, one.most);
  all.lo95 = std::min(all.lo95, one.lo95);
  all.hi95 = std::max(all.hi95, one.hi95);
}

}  // namespace

std::optional<PatchExtent> patch_extent(
    const std::vector<Hypothesis>& hypotheses,
    const EffectInstance& own,
    double explained,
    const effects::TestContext& context) {
  if (own.effect->changes_stiffness() != ChangeKind::Elements) {
    return std::nullopt;
  }
  std::optional<PatchExtent> all;
  std::size_t patches = 0;
  for (const Hypothesis& h : hypotheses) {
    if (h.own().effect != own.effect ||
        h.own().where.variant != own.where.variant ||
        !share(h.own().where.elements, own.where.elements) ||
        h.fit.result.error > explained) {
      continue;
    }
    ++patches;
    const PatchExtent one = extent_of(h, context);
    if (all) {
      join(one, *all);
    } else {
      all = one;
    }
  }
  return patches > 1 ? all : std::nullopt;
}

void widen(const PatchExtent& extent, Estimate& factor) {
  constexpr double in_95 = 2.0 * 1.96;  // standard deviations
  factor.lo95 = std::min(factor.lo95, extent.lo95);
  factor.hi95 = std::max(factor.hi95, extent.hi95);
  factor.sd = std::max(factor.sd, (factor.hi95 - factor.lo95) / in_95);
}

std::string statement(const PatchExtent& extent) {
  return fmt::format(
      "stiffness-loss: patches of {} to {} elements there leave no more than "
      "the floor, with factors of {:.2g} to {:.2g}: how large it is and how "
      "much it has lost is not told apart; hit more densely around it",
      extent.fewest,
      extent.most,
      extent.lo95,
      extent.hi95);
}

}  // namespace tapfit::updating
