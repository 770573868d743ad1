// A support that gives way: the constrained rotation (about the clamp's line)
// or translation is released and held by springs, k per metre of clamp. Its
// forms have both, a k that runs linearly from one end of the line to the
// other, or one k per area of the face (support_face.hpp).
#include "updating/effects/effects.hpp"
#include "updating/places/support_groups.hpp"
#include "updating/places/support_line.hpp"
#include "updating/structure/edit/deck_cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace tapfit::effects {
namespace {

std::vector<updating::SupportPart> parts_of(const Location& where,
                                            const TestContext& context) {
  return updating::support_parts(*context.deck, where.nodes, where.variant);
}

using updating::SupportMotion;

std::string total_name(SupportMotion motion) {
  return motion == SupportMotion::Translation
             ? "translational_stiffness_n_per_m"
             : "rotational_stiffness_nm_per_rad";
}

std::string parameter_name(const updating::SupportPart& part) {
  if (part.motion == SupportMotion::Face) return "bed_stiffness_n_per_m3";
  const std::string name = total_name(part.motion) + "_per_m";
  return part.end == 0 ? name : fmt::format("{}.{}", name, part.end);
}

// Of a face along one axis [m^2].
double area_of(const updating::SupportPart& face) {
  double area = 0.0;
  for (const updating::SupportDof& dof : face.line.dofs) {
    if (dof.component == 1 && dof.with == 0) area += dof.length;
  }
  return area;
}

struct Spring {
  int node = 0;
  int component = 0;  // 1..6
  int with = 0;       // 0: to ground
  double stiffness = 0.0;
};

// One for each degree of freedom, however many stiffnesses share in it.
std::vector<Spring> springs_of(const std::vector<updating::SupportPart>& parts,
                               const std::vector<double>& p) {
  std::vector<Spring> springs;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    for (const updating::SupportDof& dof : parts[k].line.dofs) {
      const auto known = std::ranges::find_if(springs, [&dof](const Spring& s) {
        return s.node == dof.node && s.component == dof.component &&
               s.with == dof.with;
      });
      if (known != springs.end()) {
        known->stiffness += p[k] * dof.length;
      } else {
        springs.push_back(
            {dof.node, dof.component, dof.with, p[k] * dof.length});
      }
    }
  }
  return springs;
}

class SoftSupport final : public Effect {
 public:
  SoftSupport()
      : Effect(
            {.name = "soft-support",
             .words = "support that gives",
             .sits = Sits::OnLine,
             .changes_stiffness = updating::ChangeKind::Support,
             .forms = {
                 "face", "both", "rotation-varying", "translation-varying"}}) {}

  // The rotation and the translation of each support, as far as it is held.
  std::vector<Location> places(const TestContext& context) const override {
    std::vector<Location> result;
    if (context.deck == nullptr) return result;
    for (const std::vector<int>& group :
         updating::support_choices(*context.deck)) {
      for (const char* variant : {"rotation", "translation"}) {
        Location where{.nodes = group, .variant = variant};
        if (!parts_of(where, context).empty()) result.push_back(where);
      }
    }
    return result;
  }

  bool takes(const std::string& form,
             const Location& place,
             const TestContext& context) const override {
    const bool any = form == "both" || form == "face";
    if (!any && !form.starts_with(place.variant)) return false;
    Location where = place;
    where.variant = form;
    return !parts_of(where, context).empty();
  }

  std::vector<ParameterSpec> parameters(
      const Location& where, const TestContext& context) const override {
    // The scale at which a support is as soft as the structure's inertia is
    // heavy at the band's ends; the fit starts from a scan over this range.
    const double low = context.low();
    const double high = context.high();
    std::vector<ParameterSpec> specs;
    for (const updating::SupportPart& part : parts_of(where, context)) {
      const bool is_face = part.motion == SupportMotion::Face;
      // A face gives in its turn first.
      const double held = is_face ? part.turn : part.line.length;
      const double size = part.motion == SupportMotion::Translation ? 1.0 : 0.1;
      const double per_length = context.mass_kg * size / held;
      specs.push_back(spread(parameter_name(part),
                             1e-2 * low * low * per_length,
                             1e4 * high * high * per_length));
    }
    return specs;
  }

  std::vector<Derived> derived(const Location& where,
                               const TestContext& context) const override {
    std::vector<Derived> totals;
    const std::vector<updating::SupportPart> parts = parts_of(where, context);
    const auto add =
        [&](const std::string& name, std::size_t k, double factor) {
          if (totals.empty() || totals.back().name != name) {
            totals.push_back({name, std::vector<double>(parts.size(), 0.0)});
          }
          totals.back().factors[k] = factor;
        };
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const updating::SupportPart& part = parts[k];
      if (part.motion != SupportMotion::Face) {
        add(total_name(part.motion), k, part.line.length);
        continue;
      }
      for (const auto& [motion, whole] :
           {std::pair{SupportMotion::Rotation, part.turn},
            std::pair{SupportMotion::Translation, area_of(part)}}) {
        add(total_name(motion), k, whole);
        add(total_name(motion) + "_per_m", k, whole / part.line.length);
      }
    }
    return totals;
  }

  std::vector<structure::Constraint> released(
      const Location& where, const TestContext& context) const override {
    std::vector<structure::Constraint> result;
    const std::vector<updating::SupportPart> parts = parts_of(where, context);
    for (const Spring& spring :
         springs_of(parts, std::vector<double>(parts.size(), 1.0))) {
      if (spring.with != 0) continue;
      const auto own =
          card_component(*context.deck, spring.node, spring.component);
      if (own) result.push_back({spring.node, std::to_string(*own)});
    }
    return result;
  }

  std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext& context,
      const std::vector<double>& p) const override {
    std::vector<std::string> cards;
    int offset = 0;
    const auto append = [&](const std::vector<std::string>& more) {
      cards.insert(cards.end(), more.begin(), more.end());
      offset += static_cast<int>(more.size());
    };
    for (const auto& [node, component, with, stiffness] :
         springs_of(parts_of(where, context), p)) {
      if (with != 0) {
        append(structure::coupling_spring_cards(
            *context.deck, offset, node, {component, with}, stiffness));
        continue;
      }
      if (!card_component(*context.deck, node, component)) {
        cards.push_back(fmt::format(
            "$ grid {}: no component along its axes (CD) is the one released; "
            "give it CD 0, then a CELAS2 of {:.4g} {} on component {}",
            node,
            stiffness,
            component > 3 ? "N m/rad" : "N/m",
            component));
        continue;
      }
      append(ground_spring_cards(
          *context.deck, offset, node, component, stiffness));
    }
    return cards;
  }
};

}  // namespace

const Effect& soft_support() {
  static const SoftSupport effect;
  return effect;
}

}  // namespace tapfit::effects
