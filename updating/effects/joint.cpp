// A joint that gives: along a line of grids the elements on one side turn
// against the rest, held by a spring, k per metre of line. A bolted or bonded
// seam, a weld that did not take. Its form "crack" parts them over some of the
// line's grids, held by k per area of the two faces: next to nothing for a
// crack that is open, more for one that is bonded or rubs.
#include "updating/effects/effects.hpp"
#include "updating/effects/joint_cards.hpp"
#include "updating/places/crack_line.hpp"
#include "updating/places/joint_line.hpp"

namespace tapfit::effects {
namespace {

double length_of(const Location& where, const TestContext& context) {
  if (where.nodes.size() < 2) return 1.0;
  return updating::shell_joint(*context.deck, where.nodes).length;
}

// Second moment of a crack's face [m^4].
double turn_of(const Location& where, const TestContext& context) {
  double turn = 0.0;
  for (const updating::PartedGrid& grid :
       updating::crack_line(*context.deck, where.nodes).grids) {
    turn += grid.turn;
  }
  return turn;
}

class Joint final : public Effect {
 public:
  Joint()
      : Effect({.name = "joint",
                .words = "joint that gives",
                .sits = Sits::OnLine,
                .changes_stiffness = updating::ChangeKind::Joint,
                .forms = {updating::crack}}) {}

  // Each straight line across shells, lines in line with each other together,
  // each place where bars meet.
  std::vector<Location> places(const TestContext& context) const override {
    std::vector<Location> result;
    if (context.deck == nullptr) return result;
    for (const updating::JointPlace& place :
         updating::joint_places(*context.deck)) {
      result.push_back({.nodes = place.nodes});
      if (place.bar != 0) result.back().elements = {place.bar};
    }
    return result;
  }

  // A crack at a line of shells.
  bool takes(const std::string& form,
             const Location& place,
             const TestContext& context) const override {
    return form == updating::crack && context.deck != nullptr &&
           !updating::crack_line(*context.deck, place.nodes).grids.empty();
  }

  std::vector<ParameterSpec> parameters(
      const Location& where, const TestContext& context) const override {
    // As for a soft support; the base narrows it to what shows.
    const bool is_crack = where.variant == updating::crack;
    const double length =
        is_crack ? turn_of(where, context) : length_of(where, context);
    const double m = context.mass_kg;
    return {spread(is_crack ? "bed_stiffness_n_per_m3"
                            : "rotational_stiffness_nm_per_rad_per_m",
                   1e-3 * m * context.low() * context.low() / length,
                   1e3 * m * context.high() * context.high() / length)};
  }

  std::vector<Derived> derived(const Location& where,
                               const TestContext& context) const override {
    // Of a crack the faces' stiffness is all there is to tell.
    if (where.variant == updating::crack) return {};
    return {{"rotational_stiffness_nm_per_rad", {length_of(where, context)}}};
  }

  // Of what the elements on one side need besides: see joint_cards.hpp.
  std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext& context,
      const std::vector<double>& p) const override {
    return joint_cards(where, context, p[0]).added;
  }
};

}  // namespace

const Effect& joint() {
  static const Joint effect;
  return effect;
}

}  // namespace tapfit::effects
