#include "updating/effects/stiffness_loss.hpp"

#include "updating/effects/effects.hpp"
#include "updating/places/element_patches.hpp"
#include "updating/places/stretched_patches.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <utility>

namespace tapfit::effects {

double thickness_left(double p) { return std::cbrt(p); }

double thickness_left_slope(double p) { return std::cbrt(p) / (3.0 * p); }

std::vector<std::vector<int>> weakened_beside(const Location& where,
                                              const structure::Deck& deck) {
  if (!updating::has_edges(where)) return {};
  return updating::layers_beside(where.elements, deck);
}

namespace {

class StiffnessLoss final : public Effect {
 public:
  StiffnessLoss()
      : Effect(
            {.name = "stiffness-loss",
             .words = "loss of stiffness",
             .sits = Sits::OnElements,
             .changes_stiffness = updating::ChangeKind::Elements,
             .forms = {
                 updating::pocket, updating::edges, updating::pocket_edges}}) {}

  // Each element, patches of growing size around it, whole properties.
  std::vector<Location> places(const TestContext& context) const override {
    std::vector<Location> result;
    if (context.deck == nullptr) return result;
    for (std::vector<int>& patch : updating::element_patches(*context.deck)) {
      result.push_back({.elements = std::move(patch)});
    }
    return result;
  }

  std::vector<ParameterSpec> parameters(
      const Location& where, const TestContext& context) const override {
    std::vector<ParameterSpec> specs = {{"factor", 0.5, 0.04, 1.0}};
    const std::size_t edges = weakened_beside(where, *context.deck).size();
    for (std::size_t edge = 1; edge <= edges; ++edge) {
      specs.push_back({fmt::format("edge_{}_factor", edge), 0.9, 0.04, 1.0});
    }
    return specs;
  }

  std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext& context,
      const std::vector<double>& p) const override {
    const auto line = [&where](const std::vector<int>& elements, double left) {
      return fmt::format(
          "$ Stiffness of elements {} times {:.4g}{}: they have a "
          "property and material of their own above",
          fmt::join(elements, ", "),
          left,
          updating::takes_mass(where)
              ? fmt::format(", thickness times {:.4g}", thickness_left(left))
              : "");
    };
    std::vector<std::string> lines = {line(where.elements, p.front())};
    for (const auto& layer : weakened_beside(where, *context.deck)) {
      lines.push_back(line(layer, p[lines.size()]));
    }
    return lines;
  }
};

}  // namespace

const Effect& stiffness_loss() {
  static const StiffnessLoss effect;
  return effect;
}

}  // namespace tapfit::effects
