// Hammer tests of plates and frames whose truth is of solid elements and whose
// deck is of shells or bars, with something hidden in most of them.
//
//   solid_cases_study FOLDER SEED [STRUCTURE]
//
// Makes a bundle with a truth.json for each case; a diagnosis of each is then
// judged against it. Eight plates: with a window, held at both ends, bent,
// stepped, an L, tapered and twisted, ribbed, a free sector of a ring; a fold
// and a channel. Four frames: a portal, an arm with a corner, a ladder, a tee.
#include "tests/studies/solid_plate.hpp"
#include "tests/studies/solid_structures.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace tapfit::updating::testing {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using json = nlohmann::ordered_json;

double mass_of(const SolidPlate& plate) {
  double volume = 0.0;
  for (int j = 0; j < plate.rows; ++j) {
    for (int i = 0; i < plate.columns; ++i) {
      if (plate.has_cell && !plate.has_cell(i, j)) continue;
      const Vector3d a = place_of(plate, i + 1, j) - place_of(plate, i, j);
      const Vector3d b = place_of(plate, i, j + 1) - place_of(plate, i, j);
      volume += a.cross(b).norm() * plate.thickness *
                (plate.thicker ? plate.thicker(i, j) : 1.0);
    }
  }
  return plate.density * volume;
}

struct Case {
  std::string kind;
  std::vector<std::string> effects = {};  // as `simulate` takes them
  HiddenInSolid hidden = {};
  json truth = json::array();
};

json at(const Vector3d& place) { return {place(0), place(1), place(2)}; }

// Everything hidden is a share of what the structure has itself.
class Cases {
 public:
  Cases(const SolidPlate& plate, double first_hz, unsigned seed)
      : plate_(plate),
        engine_(seed),
        mass_(mass_of(plate)),
        omega_(2.0 * std::numbers::pi * first_hz) {}

  std::vector<Case> all() {
    std::vector<Case> cases{{"none"}, {"none"}};
    cases.push_back(sensors(0.015 * mass_));
    cases.push_back(at_grid("added-mass", "mass_kg", 0.04 * mass_));
    cases.push_back(at_grid(
        "ground-spring", "stiffness_n_per_m", 0.15 * mass_ * omega_ * omega_));
    cases.push_back(
        at_grid("dashpot", "damping_ns_per_m", 0.02 * mass_ * omega_));
    cases.push_back(pocket());
    cases.push_back(gain());
    cases.push_back(with(pocket(), sensors(0.012 * mass_)));
    if (is_held()) {
      cases.push_back(bed());
      cases.push_back(with(bed(), sensors(0.012 * mass_)));
    }
    cases.push_back(absorber());
    cases.push_back(crack());
    return cases;
  }

 private:
  [[nodiscard]] bool is_even_where_held() const {
    std::set<double> thickness;
    for (int j = 0; plate_.thicker && j < plate_.rows; ++j) {
      for (int i = 0; i < plate_.columns; ++i) {
        const bool held = plate_.is_held(i, j) || plate_.is_held(i + 1, j + 1);
        if (held) thickness.insert(plate_.thicker(i, j));
      }
    }
    return thickness.size() < 2;
  }

  static Case with(Case one, const Case& other) {
    one.kind += "+" + other.kind;
    one.effects.insert(
        one.effects.end(), other.effects.begin(), other.effects.end());
    for (const json& effect : other.truth) one.truth.push_back(effect);
    return one;
  }

  [[nodiscard]] bool is_held() const {
    for (int j = 0; j <= plate_.rows; ++j) {
      for (int i = 0; i <= plate_.columns; ++i) {
        if (plate_.is_held(i, j)) return true;
      }
    }
    return false;
  }

  Case sensors(double mass) {
    Case it{"sensor-mass", {fmt::format("sensor-mass={:.6g}", mass)}};
    it.truth.push_back({{"effect", "sensor-mass"}, {"mass_kg", mass}});
    return it;
  }

  // Somewhere away from what is held.
  std::array<int, 2> grid() {
    std::uniform_int_distribution<int> column(0, plate_.columns);
    std::uniform_int_distribution<int> row(0, plate_.rows);
    while (true) {
      const int i = column(engine_);
      const int j = row(engine_);
      const bool there = !plate_.has_cell || has_cell(i, j);
      if (there && is_away(i, j)) return {i, j};
    }
  }

  [[nodiscard]] bool is_away(int i, int j) const {
    const int far = std::max(plate_.columns, plate_.rows) / 3;
    for (int b = 0; b <= plate_.rows; ++b) {
      for (int a = 0; a <= plate_.columns; ++a) {
        if (!plate_.is_held(a, b)) continue;
        if (std::hypot(a - i, b - j) < far) return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool has_cell(int i, int j) const {
    return i >= 0 && j >= 0 && i < plate_.columns && j < plate_.rows &&
           (!plate_.has_cell || plate_.has_cell(i, j));
  }

  Case at_grid(const std::string& effect,
               const std::string& size,
               double value,
               const std::string& more = {}) {
    const auto [i, j] = grid();
    const double middle = plate_.of_bars ? 0.5 : 0.0;
    Case it{effect,
            {fmt::format(
                "{}@{}={:.6g}{}", effect, grid_id(plate_, i, j), value, more)}};
    it.truth.push_back({{"effect", effect},
                        {size, value},
                        {"at", at(place_of(plate_, i + middle, j + middle))}});
    return it;
  }

  // Tuned between the first mode and half as much again.
  Case absorber() {
    std::uniform_real_distribution<double> tuning(0.9, 1.6);
    const double hz = tuning(engine_) * omega_ / (2.0 * std::numbers::pi);
    return at_grid(
        "absorber", "mass_kg", 0.03 * mass_, fmt::format(",{:.5g},0.02", hz));
  }

  // From an edge inwards, over a third of the rows there or half of a member.
  Case crack() {
    Case it{"crack"};
    std::uniform_int_distribution<int> column(2, plate_.columns - 2);
    while (true) {
      const int i = column(engine_);
      int first = 0;
      while (first < plate_.rows &&
             !(has_cell(i - 1, first) && has_cell(i, first))) {
        ++first;
      }
      int last = first;
      while (has_cell(i - 1, last) && has_cell(i, last)) ++last;
      if (last == first) continue;
      const int n = plate_.split;
      const int solids = n * (last - first);
      const int rows = plate_.of_bars ? solids / 2 : solids / 3;
      const double middle = first + 0.5 * rows / n;
      it.hidden.crack = {n * i, n * first, n * first + rows - 1};
      it.truth.push_back(
          {{"effect", "crack"}, {"at", at(place_of(plate_, i, middle))}});
      return it;
    }
  }

  // Of three cells in a row or a column of a frame, of three by three else.
  Case pocket() {
    if (plate_.of_bars) return thin_member();
    Case it{"thinning"};
    std::uniform_int_distribution<int> column(1, plate_.columns - 4);
    std::uniform_int_distribution<int> row(0, std::max(0, plate_.rows - 3));
    int i = 0;
    int j = 0;
    do {
      i = column(engine_);
      j = row(engine_);
    } while (plate_.has_cell &&
             !(plate_.has_cell(i, j) && plate_.has_cell(i + 2, j + 2) &&
               plate_.has_cell(i, j + 2) && plate_.has_cell(i + 2, j)));
    it.hidden.pocket = {i, i + 2, j, j + 2};
    it.hidden.left = 0.6;
    it.truth.push_back({{"effect", "thinning"},
                        {"left", it.hidden.left},
                        {"at", at(place_of(plate_, i + 1.5, j + 1.5))}});
    return it;
  }

  Case thin_member() {
    std::uniform_int_distribution<int> turned(0, 1);
    while (true) {
      const auto [i, j] = grid();
      const int di = turned(engine_);
      const int dj = 1 - di;
      if (!has_cell(i - di, j - dj) || !has_cell(i + di, j + dj)) continue;
      Case it{"thinning"};
      it.hidden.pocket = {i - di, i + di, j - dj, j + dj};
      it.hidden.left = 0.7;
      it.truth.push_back({{"effect", "thinning"},
                          {"left", it.hidden.left},
                          {"at", at(place_of(plate_, i + 0.5, j + 0.5))}});
      return it;
    }
  }

  Case bed() {
    Case it{"soft-support"};
    const double span = plate_.columns * plate_.pitch;
    it.hidden.bed = 15.0 * plate_.E / span;
    // Lumped springs, a third each at the faces and the middle of every layer:
    // sum k z^2 = bed sum h (z_0^2 + z_m^2 + z_1^2) / 3, a bit over t^3 / 12.
    const double t =
        plate_.thickness * (plate_.thicker ? plate_.thicker(0, 0) : 1.0);
    const double h = t / plate_.layers;
    double turn = 0.0;
    for (int k = 0; k < 2 * plate_.layers + 1; ++k) {
      const double z = 0.5 * (k * h - t);
      const bool outer = k == 0 || k == 2 * plate_.layers;
      turn += (k % 2 == 1 || outer ? 1.0 : 2.0) * h / 3.0 * z * z;
    }
    it.truth.push_back({{"effect", "soft-support"}, {"kind", "face"}});
    // A bar turns unlike about its two axes, a ribbed edge unlike along it.
    if (plate_.of_bars || !is_even_where_held()) return it;
    it.truth.back()["reference"] = {
        {"rotational_stiffness_nm_per_rad_per_m", it.hidden.bed * turn}};
    return it;
  }

  Case gain() {
    Case it{"channel-gain", {"channel-gain@acc1=0.85"}};
    it.truth.push_back(
        {{"effect", "channel-gain"}, {"channel", 1}, {"gain", 0.85}});
    return it;
  }

  const SolidPlate& plate_;
  std::mt19937 engine_;
  double mass_;
  double omega_;
};

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

VirtualBundleSpec spec_of(const SolidPlate& plate,
                          const Case& it,
                          const fs::path& decks,
                          unsigned seed) {
  write(decks / "model.bdf", engineers_deck(plate));
  write(decks / "solids.bdf", solid_deck(plate, it.hidden));
  VirtualBundleSpec spec;
  spec.structure = decks / "model.bdf";
  spec.truth = decks / "solids.bdf";
  for (const std::string& text : it.effects) {
    spec.effects.push_back(parse_virtual_effect(text));
  }
  spec.seed = seed;
  spec.points = 12;
  spec.band_hz = plate.band_hz;
  std::mt19937 engine(seed);
  spec.modulus_percent = std::normal_distribution<double>(0.0, 2.0)(engine);
  return spec;
}

void make(const SolidPlate& plate, const fs::path& folder, unsigned seed) {
  const fs::path decks = folder / ("decks-" + plate.name);
  fs::create_directories(decks);
  const fs::path plain = decks / "plain";
  const double first_hz =
      make_virtual_bundle(spec_of(plate, {"none"}, decks, seed), plain)
          .model_hz.front();
  std::map<std::string, int> count;
  for (const Case& it : Cases(plate, first_hz, seed).all()) {
    std::string name = fmt::format("{}-{}", plate.name, it.kind);
    if (const int n = ++count[name]; n > 1) name += fmt::format("-{}", n);
    const VirtualBundleSpec spec = spec_of(plate, it, decks, ++seed);
    const VirtualBundleResult result = make_virtual_bundle(spec, folder / name);
    const json truth{{"name", name},
                     {"structure", plate.name},
                     {"seed", seed},
                     {"dE", *spec.modulus_percent / 100.0},
                     {"kind", it.kind},
                     {"pitch", plate.pitch},
                     {"effects", it.truth},
                     {"model_hz", result.model_hz},
                     {"true_hz", result.true_hz}};
    write(folder / name / "truth.json", truth.dump(1));
    fmt::print("{}: model {:.0f}, truth {:.0f} Hz\n",
               name,
               fmt::join(result.model_hz, " "),
               fmt::join(result.true_hz, " "));
  }
}

}  // namespace
}  // namespace tapfit::updating::testing

int main(int argc, char** argv) {
  using namespace tapfit::updating::testing;
  if (argc < 3) {
    fmt::print(stderr, "usage: solid_cases_study FOLDER SEED [STRUCTURE]\n");
    return 2;
  }
  unsigned seed = static_cast<unsigned>(std::atoi(argv[2]));
  for (const SolidPlate& plate : solid_structures()) {
    if (argc < 4 || plate.name == argv[3]) make(plate, argv[1], seed);
    seed += 100;
  }
}
