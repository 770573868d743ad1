#include "updating/practice/practice_case.hpp"

#include "acquisition/foundation/constants.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/seeded_random.hpp"
#include "updating/frf_model/model_modes.hpp"
#include "updating/places/element_patches.hpp"
#include "updating/places/joint_line.hpp"
#include "updating/places/support_groups.hpp"
#include "updating/reduction/reduced_base.hpp"
#include "updating/virtual_test/structure_presets.hpp"
#include "updating/virtual_test/virtual_setup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace tapfit::updating {
namespace {

using acquisition::SeededRandom;
using structure::Deck;

// A test that a practice case may be cut down to.
constexpr std::size_t fewest_points = 12;
// A support that gives more at one end than at the other, one that holds every
// turn but moves, and one that does both.
constexpr const char* uneven = "uneven-soft-support";
constexpr const char* moving = "moving-soft-support";
constexpr const char* loose = "turning-and-moving-soft-support";
// Sensors of two makes.
constexpr const char* unequal = "unequal-sensor-mass";

// Everything that sizes are scaled by.
class Draw {
 public:
  Draw(const std::string& structure, std::uint64_t seed)
      : random_(seed, "hidden case"), setup_(set_up(blank(structure, seed))) {
    BaseOptions options;
    options.high_hz = setup_.band_hz[1];
    options.split = false;
    std::set<int> points;
    for (const VirtualRun& run : setup_.runs) {
      for (const VirtualSensor& sensor : run.sensors) {
        points.insert(6 * static_cast<int>(deck().grid_index(sensor.dof.node)) +
                      sensor.dof.component - 1);
      }
    }
    options.points.assign(points.begin(), points.end());
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
    if (name == "nonlinearity") {
      VirtualEffect spring = at_grid(name, {});
      const double x = stretch_at(std::stoi(spring.places[0]));
      // A linear spring of this stiffness has the cubic one's fundamental.
      const double mean = mass * w * w * log_uniform(0.01, 0.1);
      spring.values = {mean / (0.75 * x * x)};
      return spring;
    }
    if (name == "sensor-mass") {
      return {name, {}, {mass * random_.uniform(0.01, 0.03)}};
    }
    if (name == "sensor-cable") {
      return {name,
              {},
              {mass * w * w * log_uniform(0.02, 0.2),
               2.0 * mass * w * log_uniform(0.002, 0.01)}};
    }
    // What a plastic does in a room that warms up by a few degrees.
    if (name == "drift") return {name, {}, {random_.uniform(2.0, 5.0)}};
    if (name == "wrong-grid") return wrong_grid(name);
    if (name == unequal) {
      const double light = mass * random_.uniform(0.005, 0.015);
      const double heavy = light * random_.uniform(1.5, 3.0);
      return either_way({"sensor-mass", {}, {light, heavy}});
    }
    if (name.ends_with("soft-support")) return support(name);
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
      const double turn = random_.uniform(0.02, 0.08);
      const double sign = random_.uniform(0, 1) < 0.5 ? -1.0 : 1.0;
      return {name, {channel}, {sign * turn / setup_.band_hz[1]}};
    }
    if (name == "channel-polarity") return {name, {channel}, {}};
    if (name == "channel-swap") {
      return {name,
              {setup_.sensor_channels.at(0), setup_.sensor_channels.at(1)},
              {}};
    }
    throw InputError("no such effect to hide: " + name,
                     "hidden case",
                     "take one of practice_kinds()");
  }

 private:
  VirtualEffect either_way(VirtualEffect effect) {
    if (random_.uniform(0, 1) < 0.5) {
      std::swap(effect.values[0], effect.values[1]);
    }
    return effect;
  }

  VirtualEffect support(const std::string& name) {
    VirtualEffect result{"soft-support", {}, {}};
    if (name == moving || name == loose) {
      result.form = name == moving ? "translation" : "both";
      if (name == loose) result.values.push_back(felt_spring("rotation"));
      result.values.push_back(felt_spring("translation"));
      return result;
    }
    result.values.push_back(typical(clamp("rotation")) * log_uniform(0.3, 3.0));
    if (name != uneven) return result;
    // One end's bolts were forgotten.
    result.values.push_back(result.values[0] * log_uniform(0.05, 0.2));
    return either_way(std::move(result));
  }

  // A spring of the clamp that lowers omega^2 of one mode in the band by a few
  // to thirty percent. The first order does not do here: much of the force on a
  // clamp keeps itself in balance and is let go within an element or two.
  double felt_spring(const std::string& variant) {
    const ReducedBase base = builder_->build({}, {clamp(variant)});
    const StiffnessTerm& term = base.terms.front();
    const auto squares = [&](double k) {
      const BaseModes modes =
          solve_modes(base.K + (k - term.included) * term.S,
                      Eigen::MatrixXd::Identity(base.size(), base.size()),
                      false);
      Eigen::VectorXd ascending = modes.omega.cwiseAbs2();
      std::sort(ascending.begin(), ascending.end());
      return Eigen::VectorXd(
          ascending.head(static_cast<Eigen::Index>(elastic_hz_.size())));
    };
    const Eigen::VectorXd rigid = squares(term.absent);
    const double wanted = log_uniform(0.03, 0.3);
    double soft = std::log(term.lower);
    double stiff = std::log(term.upper);
    while (stiff - soft > 1e-3) {
      const double k = 0.5 * (soft + stiff);
      const double fall =
          1.0 - squares(std::exp(k)).cwiseQuotient(rigid).minCoeff();
      (fall > wanted ? soft : stiff) = k;
    }
    return std::exp(soft);
  }

  StiffnessChange clamp(const std::string& variant) {
    StiffnessChange change;
    change.kind = ChangeKind::Support;
    change.component = setup_.component;
    const std::vector<std::vector<int>> supports = support_choices(deck());
    if (!supports.empty()) change.of.where.nodes = supports.back();
    change.of.where.variant = variant;
    return change;
  }

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

  // How far an ordinary hit at a grid makes it swing [m]: its impulse, taken up
  // by the elastic modes.
  double stretch_at(int grid) {
    const double impulse =
        0.56 * setup_.hand.peak_n * setup_.hand.width_s;  // mean of sin^1.5
    const auto row = 6 * static_cast<Eigen::Index>(deck().grid_index(grid)) +
                     setup_.component - 1;
    const auto modes = static_cast<Eigen::Index>(setup_.model_hz.size());
    const Eigen::RowVectorXd at = base_.rows.row(row);
    double stretch = 0.0;
    for (Eigen::Index k = 0; k < modes; ++k) {
      const double hz = setup_.model_hz[static_cast<std::size_t>(k)];
      if (hz <= 1e-3 * setup_.band_hz[1]) continue;
      stretch += std::pow(at(k), 2) / (two_pi * hz);
    }
    return impulse * stretch;
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

  // A hit point that a short test has too, and one of the grids around it that
  // move, two elements or more away.
  VirtualEffect wrong_grid(const std::string& name) {
    // The first points are the sensors'.
    const std::size_t sensors = setup_.sensor_channels.size();
    const std::size_t run = sensors + pick(fewest_points - sensors);
    const int hit = setup_.runs[run].hammer.node;
    const Eigen::Vector3d& at = deck().grids[deck().grid_index(hit)].position;
    std::vector<std::pair<double, int>> near;
    for (std::size_t k = 0; k < deck().grids.size(); ++k) {
      const auto row = 6 * static_cast<Eigen::Index>(k) + setup_.component - 1;
      if (base_.rows.row(row).norm() == 0.0) continue;
      near.emplace_back((deck().grids[k].position - at).norm(),
                        deck().grids[k].id);
    }
    std::sort(near.begin(), near.end());
    const double far = 1.9 * near.at(1).first;
    std::erase_if(near, [far](const auto& grid) { return grid.first < far; });
    return {name,
            {std::to_string(hit), std::to_string(near.at(pick(8)).second)},
            {}};
  }

  VirtualEffect joint(const std::string& name) {
    std::vector<JointPlace> places = joint_places(deck());
    // Which of three bars turns is not asked for.
    std::erase_if(places,
                  [](const JointPlace& place) { return place.bar != 0; });
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

}  // namespace

const std::vector<std::string>& practice_kinds() {
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
                                                 "channel-swap",
                                                 "sensor-cable",
                                                 "drift",
                                                 "wrong-grid",
                                                 "nonlinearity",
                                                 uneven,
                                                 moving,
                                                 loose,
                                                 unequal};
  return kinds;
}

bool can_hide(const std::string& structure, const std::string& kind) {
  return structure != "plate" || kind.find("soft-support") == std::string::npos;
}

VirtualBundleSpec draw_practice_case(const std::string& kind,
                                     std::uint64_t seed,
                                     const std::string& structure) {
  SeededRandom random(seed, "structure");
  std::vector<std::string> structures = virtual_structures();
  std::erase_if(structures, [&kind](const std::string& name) {
    return !can_hide(name, kind);
  });
  const auto count = static_cast<double>(structures.size());
  const auto drawn = static_cast<std::size_t>(random.uniform(0.0, count));
  VirtualBundleSpec spec;
  spec.structure = structure.empty()
                       ? structures[std::min(drawn, structures.size() - 1)]
                       : structure;
  spec.seed = seed;
  spec.points = 20;
  spec.hits = 4;
  if (kind == "none") return spec;
  Draw draw(spec.structure, seed);
  std::size_t begin = 0;
  while (begin <= kind.size()) {
    const std::size_t end = std::min(kind.find('+', begin), kind.size());
    spec.effects.push_back(draw.effect(kind.substr(begin, end - begin)));
    begin = end + 1;
  }
  return spec;
}

}  // namespace tapfit::updating
