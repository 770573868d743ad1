#include "updating/hidden_case.hpp"

#include "acquisition/input_error.hpp"
#include "acquisition/seeded_random.hpp"
#include "updating/effects/catalogue.hpp"
#include "updating/element_patches.hpp"
#include "updating/joint_line.hpp"
#include "updating/reduced_base.hpp"
#include "updating/support_line.hpp"
#include "updating/virtual_setup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using acquisition::SeededRandom;
using structure::Deck;

constexpr double two_pi = 2.0 * std::numbers::pi;

// Everything that sizes are scaled by.
class Draw {
 public:
  Draw(const std::string& structure, std::uint64_t seed)
      : random_(seed, "hidden case"), setup_(set_up(blank(structure, seed))) {
    BaseOptions options;
    options.high_hz = setup_.band_hz[1];
    options.split = false;
    builder_.emplace(deck(),
                     std::vector<acquisition::UncertainProperty>{},
                     options,
                     Progress{});
    base_ = builder_->build({}, {});
    std::copy_if(setup_.model_hz.begin(),
                 setup_.model_hz.end(),
                 std::back_inserter(elastic_hz_),
                 [this](double f) { return f > 1e-3 * setup_.band_hz[1]; });
  }

  [[nodiscard]] VirtualEffect effect(const std::string& name) {
    const double mass = builder_->mass_kg();
    const double w = two_pi * elastic_hz_.at(std::min<std::size_t>(
                                  1, elastic_hz_.size() - 1));
    if (name == "added-mass") {
      return at_grid(name, {mass * random_.uniform(0.02, 0.08)});
    }
    if (name == "ground-spring") {
      return at_grid(name, {mass * w * w * log_uniform(0.02, 0.3)});
    }
    if (name == "dashpot") {
      return at_grid(name, {2.0 * mass * w * log_uniform(0.01, 0.06)});
    }
    if (name == "absorber") {
      const std::size_t mode = pick((elastic_hz_.size() + 1) / 2);
      return at_grid(name,
                     {mass * random_.uniform(0.03, 0.08),
                      elastic_hz_[mode] * random_.uniform(0.9, 1.1),
                      random_.uniform(0.01, 0.04)});
    }
    if (name == "strut") {
      VirtualEffect strut = at_grid(name, {mass * w * w});
      while (strut.places.size() < 2) {
        const std::string other = moving_grid();
        if (other != strut.places[0]) strut.places.push_back(other);
      }
      return strut;
    }
    if (name == "sensor-mass") {
      return {name, {}, {mass * random_.uniform(0.01, 0.03)}};
    }
    if (name == "soft-support") {
      StiffnessChange change;
      change.kind = ChangeKind::Support;
      change.of.where.nodes = support_groups(deck()).at(0);
      change.of.where.variant = "rotation";
      return {name, {}, {typical(change) * log_uniform(0.3, 3.0)}};
    }
    if (name == "stiffness-loss") return loss(name);
    if (name == "joint") return joint(name);
    const std::string channel =
        setup_.sensor_channels[pick(setup_.sensor_channels.size())];
    if (name == "channel-gain") {
      const double off = random_.uniform(0.08, 0.25);
      return {name,
              {channel},
              {random_.uniform(0, 1) < 0.5 ? 1.0 - off : 1.0 + off}};
    }
    if (name == "channel-delay") {
      return {
          name, {channel}, {random_.uniform(0.02, 0.08) / setup_.band_hz[1]}};
    }
    if (name == "channel-polarity") return {name, {channel}, {}};
    if (name == "channel-swap") {
      return {name,
              {setup_.sensor_channels.at(0), setup_.sensor_channels.at(1)},
              {}};
    }
    throw InputError("no such effect to hide: " + name,
                     "hidden case",
                     "take one of hidden_kinds()");
  }

 private:
  static VirtualBundleSpec blank(const std::string& structure,
                                 std::uint64_t seed) {
    VirtualBundleSpec spec;
    spec.structure = structure;
    spec.seed = seed;
    return spec;
  }

  [[nodiscard]] const Deck& deck() const { return setup_.model.model; }

  std::size_t pick(std::size_t count) {
    return std::min(count - 1,
                    static_cast<std::size_t>(
                        random_.uniform(0.0, static_cast<double>(count))));
  }

  double log_uniform(double low, double high) {
    return std::exp(random_.uniform(std::log(low), std::log(high)));
  }

  // A grid that moves at least as much as half of them do.
  std::string moving_grid() {
    const Eigen::Index modes = static_cast<Eigen::Index>(elastic_hz_.size());
    std::vector<std::pair<double, int>> order;
    for (std::size_t k = 0; k < deck().grids.size(); ++k) {
      const auto row = 6 * static_cast<Eigen::Index>(k) + setup_.component - 1;
      order.emplace_back(-base_.rows.row(row).head(modes).norm(),
                         deck().grids[k].id);
    }
    std::sort(order.begin(), order.end());
    return std::to_string(order[pick(order.size() / 2)].second);
  }

  VirtualEffect at_grid(const std::string& name, std::vector<double> values) {
    return {name, {moving_grid()}, std::move(values)};
  }

  double typical(const StiffnessChange& change) {
    return builder_->build({}, {change}).terms.front().start;
  }

  VirtualEffect loss(const std::string& name) {
    std::vector<std::vector<int>> patches = element_patches(deck());
    std::erase_if(patches, [](const std::vector<int>& patch) {
      return patch.size() < 4 || patch.size() > 24;
    });
    VirtualEffect effect{name, {}, {random_.uniform(0.25, 0.6)}};
    for (const int id : patches[pick(patches.size())]) {
      effect.places.push_back(std::to_string(id));
    }
    return effect;
  }

  VirtualEffect joint(const std::string& name) {
    const std::vector<JointPlace> places = joint_places(deck());
    StiffnessChange change;
    change.kind = ChangeKind::Joint;
    change.component = setup_.component;
    change.of.where.nodes = places[pick(places.size())].nodes;
    VirtualEffect effect{name, {}, {typical(change) * log_uniform(0.3, 2.0)}};
    for (const int id : change.of.where.nodes) {
      effect.places.push_back(std::to_string(id));
    }
    return effect;
  }

  SeededRandom random_;
  VirtualSetup setup_;
  std::optional<BaseBuilder> builder_;
  ReducedBase base_;
  std::vector<double> elastic_hz_;
};

std::vector<std::string> parts_of(const std::string& joined, char at) {
  std::vector<std::string> parts = {""};
  for (const char c : joined) {
    if (c == at) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

Eigen::Vector3d middle_of(const Deck& deck, const std::vector<int>& grids) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int id : grids) sum += deck.grids[deck.grid_index(id)].position;
  return sum / static_cast<double>(std::max<std::size_t>(grids.size(), 1));
}

std::vector<int> grids_of(const Deck& deck, const std::vector<int>& elements) {
  std::vector<int> grids;
  for (const structure::Shell& shell : deck.shells) {
    if (std::find(elements.begin(), elements.end(), shell.id) !=
        elements.end()) {
      grids.insert(grids.end(), shell.grids.begin(), shell.grids.end());
    }
  }
  return grids;
}

double longest_side(const Deck& deck) {
  double longest = 0.0;
  for (const structure::Shell& shell : deck.shells) {
    for (std::size_t k = 0; k < shell.grids.size(); ++k) {
      const int next = shell.grids[(k + 1) % shell.grids.size()];
      longest = std::max(
          longest,
          (middle_of(deck, {shell.grids[k]}) - middle_of(deck, {next})).norm());
    }
  }
  return longest;
}

// Within one element, or the same channels.
bool same_place(const VirtualEffect& hidden,
                const Where& found,
                const Deck& deck) {
  if (!found.channels.empty()) {
    return hidden.places.empty() || std::is_permutation(hidden.places.begin(),
                                                        hidden.places.end(),
                                                        found.channels.begin(),
                                                        found.channels.end());
  }
  if (hidden.places.empty()) return true;
  std::vector<int> there = found.nodes;
  if (found.node != 0) there = {found.node};
  std::vector<int> here = hidden.numbers();
  if (!found.elements.empty() && found.nodes.empty()) {
    there = grids_of(deck, found.elements);
    here = grids_of(deck, here);
  }
  const double apart = (middle_of(deck, here) - middle_of(deck, there)).norm();
  return apart <= 1.01 * longest_side(deck);
}

// The estimate that the hidden value is compared with.
const Estimate* counterpart(const VirtualEffect& hidden, const Rung& rung) {
  const bool per_metre =
      hidden.name == "soft-support" || hidden.name == "joint";
  for (const Estimate& e : rung.parameters) {
    if (!per_metre || e.name.ends_with("_per_m")) {
      if (per_metre && !e.name.ends_with("per_rad_per_m")) continue;
      return &e;
    }
  }
  return nullptr;
}

}  // namespace

const std::vector<std::string>& hidden_kinds() {
  static const std::vector<std::string> kinds = {"none",
                                                 "sensor-mass",
                                                 "soft-support",
                                                 "added-mass",
                                                 "ground-spring",
                                                 "dashpot",
                                                 "stiffness-loss",
                                                 "joint",
                                                 "absorber",
                                                 "channel-gain",
                                                 "channel-delay",
                                                 "channel-polarity",
                                                 "added-mass+soft-support",
                                                 "added-mass+channel-gain",
                                                 "sensor-mass+soft-support",
                                                 "strut",
                                                 "channel-swap"};
  return kinds;
}

VirtualBundleSpec draw_hidden_case(const std::string& kind,
                                   std::uint64_t seed) {
  static constexpr std::array<const char*, 3> structures = {
      "frame", "ladder", "plate"};
  SeededRandom random(seed, "structure");
  // The plate hangs free: it has no support to give.
  const bool held = kind.find("soft-support") != std::string::npos;
  const auto count = held ? 2.0 : 3.0;
  VirtualBundleSpec spec;
  spec.structure = structures.at(
      static_cast<std::size_t>(std::min(random.uniform(0.0, count), 2.999)));
  spec.seed = seed;
  spec.points = 20;
  spec.hits = 4;
  if (kind == "none") return spec;
  Draw draw(spec.structure, seed);
  for (const std::string& name : parts_of(kind, '+')) {
    spec.effects.push_back(draw.effect(name));
  }
  return spec;
}

Verdict judge(const VirtualBundleSpec& hidden,
              const Diagnosis& diagnosis,
              const Deck& deck) {
  Verdict verdict;
  verdict.found = diagnosis.verdict;
  verdict.error = diagnosis.error_best;
  verdict.floor = diagnosis.floor;
  std::vector<std::string> names;
  for (const VirtualEffect& effect : hidden.effects) {
    names.push_back(effect.name);
    verdict.hidden += (verdict.hidden.empty() ? "" : "+") + effect.name;
  }
  if (names.empty()) verdict.hidden = "none";
  if (names.empty() || verdict.hidden == "strut") {
    verdict.right_kind =
        verdict.found == (names.empty() ? "none" : "unexplained");
    verdict.right_place = verdict.right_kind;
    return verdict;
  }
  std::vector<std::string> found = parts_of(verdict.found, '+');
  verdict.right_kind = std::is_permutation(
      names.begin(), names.end(), found.begin(), found.end());
  if (!verdict.right_kind) return verdict;
  verdict.right_place = true;
  for (const VirtualEffect& effect : hidden.effects) {
    const auto rung = std::find_if(
        diagnosis.ladder.begin(),
        diagnosis.ladder.end(),
        [&effect](const Rung& r) { return r.added == effect.name; });
    if (rung == diagnosis.ladder.end()) continue;
    if (!same_place(effect, rung->where, deck)) verdict.right_place = false;
    const Estimate* e = counterpart(effect, *rung);
    if (e == nullptr || effect.values.empty()) continue;
    const double truth = effect.values[0];
    verdict.size_error =
        std::max(verdict.size_error, std::abs(e->value / truth - 1.0));
    ++verdict.intervals;
    verdict.intervals_hold += e->lo95 <= truth && truth <= e->hi95 ? 1 : 0;
  }
  return verdict;
}

}  // namespace tapfit::updating
