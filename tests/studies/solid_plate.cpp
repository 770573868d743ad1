#include "tests/studies/solid_plate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace tapfit::updating::testing {
namespace {

using Eigen::Vector3d;

bool has_cell(const SolidPlate& plate, int i, int j) {
  if (i < 0 || j < 0 || i >= plate.columns || j >= plate.rows) return false;
  return !plate.has_cell || plate.has_cell(i, j);
}

bool has_grid(const SolidPlate& plate, int i, int j) {
  return has_cell(plate, i, j) || has_cell(plate, i - 1, j) ||
         has_cell(plate, i, j - 1) || has_cell(plate, i - 1, j - 1);
}

double thickness_of(const SolidPlate& plate, int i, int j) {
  return plate.thickness * (plate.thicker ? plate.thicker(i, j) : 1.0);
}

// Of length 1; at a fold along a column so long that both sides keep their
// thickness.
Vector3d normal_at(const SolidPlate& plate, double u, double v) {
  constexpr double h = 1e-4;
  const Vector3d along = plate.middle(u, v + h) - plate.middle(u, v - h);
  const Vector3d here = plate.middle(u, v);
  const Vector3d before =
      (here - plate.middle(u - h, v)).cross(along).normalized();
  const Vector3d after =
      (plate.middle(u + h, v) - here).cross(along).normalized();
  return (before + after) / (1.0 + before.dot(after));
}

std::string grid_card(int id, const Vector3d& x) {
  return fmt::format("GRID,{},,{:.7g},{:.7g},{:.7g}\n", id, x(0), x(1), x(2));
}

std::string material_card(const SolidPlate& plate) {
  return fmt::format(
      "MAT1,1,{:.4e},,{},{}\n", plate.E, plate.nu, plate.density);
}

// The end of a member: the middle of the far face of a cell with one
// neighbour.
struct MemberEnd {
  int id = 0;
  int cell = 0;  // grid in the middle of it
  double column = 0.0;
  double row = 0.0;
};

std::vector<MemberEnd> member_ends(const SolidPlate& plate) {
  std::vector<MemberEnd> ends;
  if (!plate.of_bars) return ends;
  for (int j = 0; j < plate.rows; ++j) {
    for (int i = 0; i < plate.columns; ++i) {
      if (!has_cell(plate, i, j)) continue;
      int count = 0;
      MemberEnd end{0, grid_id(plate, i, j), i + 0.5, j + 0.5};
      for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        if (!has_cell(plate, i + di, j + dj)) continue;
        ++count;
        end.column -= 0.5 * di;
        end.row -= 0.5 * dj;
      }
      if (count != 1) continue;
      end.id = 5000 + static_cast<int>(ends.size());
      ends.push_back(end);
    }
  }
  return ends;
}

// The solids, on a lattice of half solids: a, b in the plane, c across.
class Solids {
 public:
  Solids(const SolidPlate& plate, const HiddenInSolid& hidden)
      : plate_(&plate),
        hidden_(&hidden),
        n_(plate.split),
        ends_(member_ends(plate)) {}

  std::string deck() {
    std::string elements;
    int id = 0;
    for (int j = 0; j < n_ * plate_->rows; ++j) {
      for (int i = 0; i < n_ * plate_->columns; ++i) {
        if (!has_cell(*plate_, i / n_, j / n_)) continue;
        for (int k = 0; k < plate_->layers; ++k) {
          elements += element(++id, i, j, k);
        }
      }
    }
    std::string held;
    int spring = 1000000;
    for (const auto& [at, share] : face_) {
      const int grid = ids_.at(at);
      if (hidden_->bed <= 0.0) {
        held += fmt::format("SPC1,1,123,{}\n", grid);
        continue;
      }
      for (int axis = 1; axis <= 3; ++axis) {
        held += fmt::format("CELAS2,{},{:.6e},{},{}\n",
                            ++spring,
                            hidden_->bed * share,
                            grid,
                            axis);
      }
    }
    const std::string control =
        hidden_->bed <= 0.0 ? "SPC = 1\nBEGIN BULK\n" : "BEGIN BULK\n";
    // Masses lumped at the surfaces would turn too heavily.
    return control + "PARAM,COUPMASS,1\n" + grids_ + elements + held +
           "PSOLID,1,1\n" + material_card(*plate_) + "ENDDATA\n";
  }

 private:
  using At = std::array<int, 3>;

  [[nodiscard]] double left_at(int i, int j) const {
    const auto& [i0, i1, j0, j1] = hidden_->pocket;
    return i >= i0 && i <= i1 && j >= j0 && j <= j1 ? hidden_->left : 1.0;
  }

  // The mean of the solids that meet there.
  [[nodiscard]] double thickness_at(int a, int b) const {
    double sum = 0.0;
    int count = 0;
    for (const int i : {(a - 1) / 2, a / 2}) {
      for (const int j : {(b - 1) / 2, b / 2}) {
        if ((a == 0 && i != 0) || (b == 0 && j != 0)) continue;
        if (!has_cell(*plate_, i / n_, j / n_)) continue;
        sum += thickness_of(*plate_, i / n_, j / n_) * left_at(i / n_, j / n_);
        ++count;
      }
    }
    return sum / count;
  }

  [[nodiscard]] Vector3d middle(int a, int b) const {
    return place_of(*plate_, a / (2.0 * n_), b / (2.0 * n_));
  }

  // Of the engineer's deck there, or 0.
  [[nodiscard]] int deck_grid(int a, int b) const {
    const int cell = 2 * n_;
    if (!plate_->of_bars) {
      if (a % cell != 0 || b % cell != 0) return 0;
      return grid_id(*plate_, a / cell, b / cell);
    }
    for (const MemberEnd& end : ends_) {
      if (std::lround(end.column * cell) == a &&
          std::lround(end.row * cell) == b)
        return end.id;
    }
    if (a % cell != n_ || b % cell != n_) return 0;
    return grid_id(*plate_, a / cell, b / cell);
  }

  // Whether a node of the solid at i is not that of its neighbour's.
  [[nodiscard]] bool is_parted(int a, int b, int i) const {
    const auto& [column, first, last] = hidden_->crack;
    return a == 2 * column && i == column && b >= 2 * first &&
           b < 2 * (last + 1);
  }

  int node(int a, int b, int c, int i) {
    const bool parted = is_parted(a, b, i);
    const auto [it, fresh] =
        (parted ? beyond_ : ids_).try_emplace({a, b, c}, 0);
    if (!fresh) return it->second;
    const int id = parted || c != plate_->layers ? 0 : deck_grid(a, b);
    it->second = id > 0 ? id : 10000 + ++count_;
    const double off =
        0.5 * (c - plate_->layers) / plate_->layers * thickness_at(a, b);
    grids_ += grid_card(it->second, middle(a, b) + off * across(a, b));
    return it->second;
  }

  // Between two corners of a solid the mean: beside a fold, too, the middle of
  // an edge stays near its middle.
  [[nodiscard]] Vector3d across(int a, int b) const {
    const auto at = [this](int i, int j) {
      return normal_at(*plate_,
                       i / (2.0 * n_ * plate_->columns),
                       j / (2.0 * n_ * plate_->rows));
    };
    return a % 2 == 0 ? at(a, b) : 0.5 * (at(a - 1, b) + at(a + 1, b));
  }

  // Springs that are the same everywhere, lumped: a twelfth of them at each
  // corner, a sixth in the middle of each edge.
  void hold_face(int a0, int b0, int a1, int b1, int k) {
    const int am = (a0 + a1) / 2;
    const int bm = (b0 + b1) / 2;
    const int c = 2 * k;
    const std::array<At, 8> nodes{At{a0, b0, c},
                                  At{a1, b1, c},
                                  At{a1, b1, c + 2},
                                  At{a0, b0, c + 2},
                                  At{am, bm, c},
                                  At{a1, b1, c + 1},
                                  At{am, bm, c + 2},
                                  At{a0, b0, c + 1}};
    const double area = (middle(a1, b1) - middle(a0, b0)).norm() *
                        thickness_at(am, bm) / plate_->layers;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      face_[nodes[n]] += area * (n < 4 ? 1.0 / 12.0 : 1.0 / 6.0);
    }
  }

  // Sides of a solid that lie on sides of its cell between two held grids.
  void hold_faces(int i, int j, int k) {
    const int ci = i / n_;
    const int cj = j / n_;
    const auto held = [&](int c0, int r0, int c1, int r1) {
      return plate_->is_held(c0, r0) && plate_->is_held(c1, r1);
    };
    const int a = 2 * i;
    const int b = 2 * j;
    if (i % n_ == 0 && held(ci, cj, ci, cj + 1)) hold_face(a, b, a, b + 2, k);
    if ((i + 1) % n_ == 0 && held(ci + 1, cj, ci + 1, cj + 1)) {
      hold_face(a + 2, b, a + 2, b + 2, k);
    }
    if (j % n_ == 0 && held(ci, cj, ci + 1, cj)) hold_face(a, b, a + 2, b, k);
    if ((j + 1) % n_ == 0 && held(ci, cj + 1, ci + 1, cj + 1)) {
      hold_face(a, b + 2, a + 2, b + 2, k);
    }
  }

  std::string element(int id, int i, int j, int k) {
    const int a = 2 * i;
    const int b = 2 * j;
    const int c = 2 * k;
    const std::array<At, 20> nodes{At{a, b, c},
                                   At{a + 2, b, c},
                                   At{a + 2, b + 2, c},
                                   At{a, b + 2, c},
                                   At{a, b, c + 2},
                                   At{a + 2, b, c + 2},
                                   At{a + 2, b + 2, c + 2},
                                   At{a, b + 2, c + 2},
                                   At{a + 1, b, c},
                                   At{a + 2, b + 1, c},
                                   At{a + 1, b + 2, c},
                                   At{a, b + 1, c},
                                   At{a, b, c + 1},
                                   At{a + 2, b, c + 1},
                                   At{a + 2, b + 2, c + 1},
                                   At{a, b + 2, c + 1},
                                   At{a + 1, b, c + 2},
                                   At{a + 2, b + 1, c + 2},
                                   At{a + 1, b + 2, c + 2},
                                   At{a, b + 1, c + 2}};
    std::string card = fmt::format("CHEXA,{},1", id);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      if (n == 6 || n == 14) card += "\n";
      const auto& [na, nb, nc] = nodes[n];
      card += fmt::format(",{}", node(na, nb, nc, i));
    }
    hold_faces(i, j, k);
    return card + "\n";
  }

  const SolidPlate* plate_;
  const HiddenInSolid* hidden_;
  int n_;
  std::vector<MemberEnd> ends_;
  int count_ = 0;
  std::map<At, int> ids_;
  std::map<At, int> beyond_;   // a crack
  std::map<At, double> face_;  // held nodes and their area [m^2]
  std::string grids_;
};

}  // namespace

std::string solid_deck(const SolidPlate& plate, const HiddenInSolid& hidden) {
  return Solids(plate, hidden).deck();
}

int grid_id(const SolidPlate& plate, int column, int row) {
  return 1 + column + (plate.columns + 1) * row;
}

Vector3d place_of(const SolidPlate& plate, double column, double row) {
  return plate.middle(column / plate.columns, row / plate.rows);
}

namespace {

std::string shell_deck(const SolidPlate& plate) {
  std::string text = "SPC = 1\nBEGIN BULK\n";
  std::string held;
  for (int j = 0; j <= plate.rows; ++j) {
    for (int i = 0; i <= plate.columns; ++i) {
      if (!has_grid(plate, i, j)) continue;
      const int id = grid_id(plate, i, j);
      text += grid_card(id, place_of(plate, i, j));
      if (plate.is_held(i, j)) held += fmt::format("SPC1,1,123456,{}\n", id);
    }
  }
  std::map<double, int> properties;
  int element = 0;
  for (int j = 0; j < plate.rows; ++j) {
    for (int i = 0; i < plate.columns; ++i) {
      if (!has_cell(plate, i, j)) continue;
      const double t = thickness_of(plate, i, j);
      const auto [it, fresh] =
          properties.try_emplace(t, static_cast<int>(properties.size()) + 1);
      if (fresh) {
        text += fmt::format("PSHELL,{},1,{:.7g},1,,1\n", it->second, t);
      }
      text += fmt::format("CQUAD4,{},{},{},{},{},{}\n",
                          ++element,
                          it->second,
                          grid_id(plate, i, j),
                          grid_id(plate, i + 1, j),
                          grid_id(plate, i + 1, j + 1),
                          grid_id(plate, i, j + 1));
    }
  }
  return text + held + material_card(plate) + "ENDDATA\n";
}

// Torsion of a rectangle, a the longer side (Young and Budynas, table 10.1).
double torsion_constant(double a, double b) {
  const double r = b / a;
  return a * b * b * b * (1.0 / 3.0 - 0.21 * r * (1.0 - r * r * r * r / 12.0));
}

// Lines through the middles of the cells, with no shear and corners that are
// points, as frames are written.
std::string bar_deck(const SolidPlate& plate) {
  const double w = plate.pitch;
  const double t = plate.thickness;
  std::string text = "SPC = 1\nBEGIN BULK\n";
  text += fmt::format("PBAR,1,1,{:.7e},{:.7e},{:.7e},{:.7e}\n",
                      w * t,
                      w * t * t * t / 12.0,
                      t * w * w * w / 12.0,
                      torsion_constant(std::max(w, t), std::min(w, t)));
  int element = 0;
  const auto bar = [&](int from, int to) {
    text += fmt::format("CBAR,{},1,{},{},0.,0.,1.\n", ++element, from, to);
  };
  for (int j = 0; j < plate.rows; ++j) {
    for (int i = 0; i < plate.columns; ++i) {
      if (!has_cell(plate, i, j)) continue;
      const int id = grid_id(plate, i, j);
      text += grid_card(id, place_of(plate, i + 0.5, j + 0.5));
      if (has_cell(plate, i + 1, j)) bar(id, grid_id(plate, i + 1, j));
      if (has_cell(plate, i, j + 1)) bar(id, grid_id(plate, i, j + 1));
    }
  }
  for (const MemberEnd& end : member_ends(plate)) {
    text += grid_card(end.id, place_of(plate, end.column, end.row));
    bar(end.id, end.cell);
    if (end.row <= 0.0) text += fmt::format("SPC1,1,123456,{}\n", end.id);
  }
  return text + material_card(plate) + "ENDDATA\n";
}

}  // namespace

std::string engineers_deck(const SolidPlate& plate) {
  return plate.of_bars ? bar_deck(plate) : shell_deck(plate);
}

}  // namespace tapfit::updating::testing
