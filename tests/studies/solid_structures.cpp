#include "tests/studies/solid_structures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::updating::testing {
namespace {

using Eigen::Vector3d;

SolidPlate window() {
  SolidPlate plate{"window", 15, 10, 0.02, 0.005, 205e9, 0.3, 7850.0};
  plate.middle = [](double u, double v) {
    return Vector3d(0.30 * u, 0.20 * v, 0.0);
  };
  plate.has_cell = [](int i, int j) {
    return i < 6 || i > 10 || j < 3 || j > 6;
  };
  plate.is_held = [](int i, int) { return i == 0; };
  plate.band_hz = {20.0, 900.0};
  return plate;
}

SolidPlate bridge() {
  SolidPlate plate{"bridge", 20, 6, 0.02, 0.006};
  plate.middle = [](double u, double v) {
    return Vector3d(0.40 * u, 0.12 * v, 0.0);
  };
  plate.is_held = [](int i, int) { return i == 0 || i == 20; };
  plate.band_hz = {50.0, 1500.0};
  return plate;
}

SolidPlate bent() {
  SolidPlate plate{"bent", 12, 10, 0.021, 0.003};
  plate.middle = [](double u, double v) {
    const double angle = 0.36 * (u - 0.5);
    return Vector3d(
        0.7 * std::sin(angle), 0.21 * v, 0.7 * (std::cos(angle) - 1.0));
  };
  plate.is_held = [](int i, int) { return i == 0; };
  plate.band_hz = {15.0, 700.0};
  return plate;
}

SolidPlate step() {
  SolidPlate plate{"step", 20, 4, 0.0175, 0.006, 205e9, 0.3, 7850.0};
  plate.middle = [](double u, double v) {
    return Vector3d(0.35 * u, 0.07 * v, 0.0);
  };
  plate.thicker = [](int i, int) { return i < 9 ? 1.6 : 1.0; };
  plate.is_held = [](int i, int) { return i == 0; };
  plate.band_hz = {20.0, 1800.0};
  return plate;
}

SolidPlate ell() {
  SolidPlate plate{"ell", 14, 14, 0.02, 0.004};
  plate.middle = [](double u, double v) {
    return Vector3d(0.28 * u, 0.28 * v, 0.0);
  };
  plate.has_cell = [](int i, int j) { return i < 5 || j < 5; };
  plate.is_held = [](int, int j) { return j == 14; };
  plate.band_hz = {10.0, 700.0};
  return plate;
}

SolidPlate blade() {
  SolidPlate plate{"blade", 18, 6, 0.018, 0.006, 110e9, 0.31, 4430.0};
  plate.middle = [](double u, double v) {
    const double chord = 0.11 - 0.05 * u;
    const double y = chord * (v - 0.5);
    const double twist = 0.30 * u;
    return Vector3d(0.32 * u, y * std::cos(twist), y * std::sin(twist));
  };
  plate.thicker = [](int i, int) { return 1.2 - 0.03 * i; };
  plate.is_held = [](int i, int) { return i == 0; };
  plate.band_hz = {20.0, 1400.0};
  return plate;
}

// A sheet folded at a right angle along a column, the other flange up.
SolidPlate fold() {
  SolidPlate plate{"fold", 16, 8, 0.02, 0.006};
  plate.middle = [](double u, double v) {
    const double along = 0.32 * u;
    return Vector3d(std::min(along, 0.2), 0.16 * v, std::max(along - 0.2, 0.0));
  };
  plate.is_held = [](int i, int) { return i == 0; };
  plate.band_hz = {15.0, 1500.0};
  return plate;
}

// A channel: a web between two flanges, held at the end of all three.
SolidPlate channel() {
  SolidPlate plate{"channel", 14, 16, 0.02, 0.005, 205e9, 0.3, 7850.0};
  plate.middle = [](double u, double v) {
    const double along = 0.28 * u;
    const double web = std::clamp(along - 0.08, 0.0, 0.12);
    const double flange =
        along < 0.08 ? 0.08 - along : std::max(along - 0.2, 0.0);
    return Vector3d(web, 0.32 * v, flange);
  };
  plate.is_held = [](int, int j) { return j == 0; };
  plate.band_hz = {50.0, 1200.0};
  return plate;
}

// Held at the bottom of its lattice.
SolidPlate frame(const std::string& name,
                 std::array<int, 2> cells,
                 double pitch,
                 std::function<bool(int, int)> has_cell) {
  SolidPlate plate{name, cells[0], cells[1], pitch};
  const double width = pitch * cells[0];
  const double height = pitch * cells[1];
  plate.middle = [=](double u, double v) {
    return Vector3d(width * u, height * v, 0.0);
  };
  plate.has_cell = std::move(has_cell);
  plate.is_held = [](int, int j) { return j == 0; };
  plate.of_bars = true;
  // So a bar of a rectangle of two to one twists 0.3 % too fast, of one by two
  // solids 3 %.
  plate.split = 4;
  plate.layers = 2;
  return plate;
}

SolidPlate portal() {
  SolidPlate plate = frame("portal", {16, 14}, 0.025, [](int i, int j) {
    return i == 0 || i == 15 || j == 13;
  });
  plate.thickness = 0.012;
  plate.E = 205e9;
  plate.nu = 0.3;
  plate.density = 7850.0;
  plate.band_hz = {20.0, 1500.0};
  return plate;
}

SolidPlate arm() {
  SolidPlate plate = frame(
      "arm", {13, 15}, 0.02, [](int i, int j) { return i == 0 || j == 14; });
  plate.thickness = 0.010;
  plate.band_hz = {10.0, 1500.0};
  return plate;
}

SolidPlate ladder() {
  SolidPlate plate = frame("ladder", {8, 20}, 0.02, [](int i, int j) {
    return i == 0 || i == 7 || j == 8 || j == 19;
  });
  plate.thickness = 0.008;
  plate.band_hz = {10.0, 1200.0};
  return plate;
}

// A mast with a head across it, nowhere near its middle.
SolidPlate tee() {
  SolidPlate plate = frame(
      "tee", {12, 16}, 0.02, [](int i, int j) { return i == 4 || j == 15; });
  plate.thickness = 0.010;
  plate.E = 205e9;
  plate.nu = 0.3;
  plate.density = 7850.0;
  plate.band_hz = {10.0, 1500.0};
  return plate;
}

// A quarter of a ring, free.
SolidPlate sector() {
  SolidPlate plate{"sector", 16, 8, 0.02, 0.006};
  plate.middle = [](double u, double v) {
    const double angle = 1.2 * u;
    const double r = 0.16 + 0.14 * v;
    return Vector3d(r * std::cos(angle), r * std::sin(angle), 0.0);
  };
  plate.is_held = [](int, int) { return false; };
  plate.band_hz = {80.0, 1600.0};
  return plate;
}

// A plate with two ribs as high above as below, held at a short side.
SolidPlate ribbed() {
  SolidPlate plate{"ribbed", 16, 9, 0.02, 0.004};
  plate.middle = [](double u, double v) {
    return Vector3d(0.32 * u, 0.18 * v, 0.0);
  };
  plate.thicker = [](int, int j) { return j == 2 || j == 6 ? 2.2 : 1.0; };
  plate.is_held = [](int i, int) { return i == 0; };
  plate.band_hz = {20.0, 1200.0};
  return plate;
}

}  // namespace

std::vector<SolidPlate> solid_structures() {
  return {window(),
          bridge(),
          bent(),
          step(),
          ell(),
          blade(),
          fold(),
          channel(),
          portal(),
          arm(),
          ladder(),
          tee(),
          sector(),
          ribbed()};
}

}  // namespace tapfit::updating::testing
