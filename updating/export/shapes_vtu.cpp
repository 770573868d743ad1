#include "updating/export/shapes_vtu.hpp"

#include "acquisition/foundation/output_file.hpp"
#include "modal/mode_set/complexity.hpp"
#include "modal/mode_set/point_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;
using Eigen::Index;

class Cells {
 public:
  explicit Cells(const structure::Deck& deck) {
    for (std::size_t i = 0; i < deck.grids.size(); ++i) {
      index_[deck.grids[i].id] = static_cast<Index>(i);
    }
  }

  /// Left out where a grid is none of the deck's.
  template <class Grids>
  void add(VtuCellType type, const Grids& grids) {
    VtuCell cell{type, {}};
    for (const int grid : grids) {
      const auto found = index_.find(grid);
      if (found == index_.end()) return;
      cell.points.push_back(found->second);
    }
    cells_.push_back(std::move(cell));
  }

  [[nodiscard]] std::vector<VtuCell> take() { return std::move(cells_); }

 private:
  std::map<int, Index> index_;
  std::vector<VtuCell> cells_;
};

VtuCellType solid_type(std::size_t corners) {
  if (corners == 4) return VtuCellType::Tetra;
  if (corners == 5) return VtuCellType::Pyramid;
  return corners == 6 ? VtuCellType::Wedge : VtuCellType::Hexahedron;
}

/// With its number: of two arrays of one name VTK keeps the last, and modes may
/// have one frequency.
std::string name_of(const char* whose, Index mode, double hz) {
  return fmt::format("{} {}, {:.5g} Hz", whose, mode + 1, hz);
}

const ModePair* pair_of(const Comparison& comparison, std::size_t measured) {
  const auto found = std::ranges::find(
      comparison.pairs, static_cast<int>(measured), &ModePair::measured);
  return found == comparison.pairs.end() ? nullptr : &*found;
}

/// Where a node is and along which axes it was measured; the test's own points
/// have axes of their own.
struct Place {
  int node = 0;
  Eigen::Vector3d position;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

std::vector<Place> measured_places(const structure::Deck& deck,
                                   const modal::ModeSet& modes) {
  std::vector<Place> places;
  for (const structure::Grid& grid : deck.grids) {
    const bool measured = std::ranges::any_of(
        modes.dofs, [&](const Dof& dof) { return dof.node == grid.id; });
    if (!measured) continue;
    Place place{grid.id, grid.position};
    for (const structure::MeasuringPoint& point : deck.measuring) {
      if (point.grid == grid.id) place.axes = point.axes;
    }
    places.push_back(place);
  }
  return places;
}

Eigen::Matrix3Xd motions_at(const std::vector<Place>& places,
                            const modal::ModeSet& modes,
                            const Eigen::VectorXd& shape) {
  const std::map<int, Eigen::Vector3d> motions =
      modal::point_motions(modes, shape);
  Eigen::Matrix3Xd at =
      Eigen::Matrix3Xd::Zero(3, static_cast<Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto found = motions.find(places[i].node);
    if (found == motions.end()) continue;
    at.col(static_cast<Index>(i)) = places[i].axes * found->second;
  }
  return at;
}

/// 0 where it is not known.
Eigen::MatrixXd errors_at(const std::vector<Place>& places,
                          const Comparison& comparison) {
  Eigen::MatrixXd errors =
      Eigen::MatrixXd::Zero(1, static_cast<Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto found = comparison.point_error.find(places[i].node);
    if (found == comparison.point_error.end()) continue;
    if (std::isfinite(found->second)) {
      errors(0, static_cast<Index>(i)) = found->second;
    }
  }
  return errors;
}

fs::path with_ending(fs::path named, const char* ending) {
  const fs::path own = named.extension();
  if (own == ".pvd" || own == ".vtu") named.replace_extension();
  return named += ending;
}

}  // namespace

VtuMesh model_mesh(const structure::Deck& deck, const ModelModes& modes) {
  VtuMesh mesh;
  const auto grids = static_cast<Index>(deck.grids.size());
  mesh.points.resize(3, grids);
  Eigen::MatrixXd ids(1, grids);
  for (Index i = 0; i < grids; ++i) {
    const structure::Grid& grid = deck.grids[static_cast<std::size_t>(i)];
    mesh.points.col(i) = grid.position;
    ids(0, i) = grid.id;
  }
  Cells cells(deck);
  for (const auto& shell : deck.shells) {
    cells.add(
        shell.grids.size() == 3 ? VtuCellType::Triangle : VtuCellType::Quad,
        shell.grids);
  }
  for (const auto& solid : deck.solids) {
    cells.add(solid_type(solid.grids.size()), solid.grids);
  }
  for (const auto& bar : deck.bars) cells.add(VtuCellType::Line, bar.grids);
  for (const auto& rod : deck.rods) cells.add(VtuCellType::Line, rod.grids);
  for (const auto& line : deck.plot_lines) cells.add(VtuCellType::Line, line);
  mesh.cells = cells.take();
  mesh.data.emplace_back("grid", ids);
  for (Index mode = 0; mode < modes.at_grids.cols(); ++mode) {
    const Eigen::VectorXd u = modes.at_grids.col(mode);
    if (u.size() != 3 * grids) continue;
    mesh.data.emplace_back(
        name_of("model", mode, modes.frequency_hz(mode)),
        Eigen::Map<const Eigen::Matrix3Xd>(u.data(), 3, grids));
  }
  return mesh;
}

VtuMesh points_mesh(const structure::Deck& deck,
                    const modal::ModeSet& modes,
                    const Comparison& comparison) {
  const std::vector<Place> places = measured_places(deck, modes);
  VtuMesh mesh;
  mesh.points.resize(3, static_cast<Index>(places.size()));
  Eigen::MatrixXd ids(1, mesh.points.cols());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto at = static_cast<Index>(i);
    mesh.points.col(at) = places[i].position;
    ids(0, at) = places[i].node;
    mesh.cells.push_back({VtuCellType::Vertex, {at}});
  }
  mesh.data.emplace_back("grid", ids);
  mesh.data.emplace_back("error", errors_at(places, comparison));
  for (std::size_t k = 0; k < modes.modes.size(); ++k) {
    const Eigen::VectorXd phi = modal::real_shape(modes.modes[k].shape);
    const ModePair* pair = pair_of(comparison, k);
    const bool paired =
        pair != nullptr && pair->model < comparison.modes.at_dofs.cols();
    const double factor =
        paired
            ? modal::factor_onto(comparison.modes.at_dofs.col(pair->model), phi)
            : 1.0;
    mesh.data.emplace_back(
        paired ? name_of("model",
                         pair->model,
                         comparison.modes.frequency_hz(pair->model))
               : name_of("measured",
                         static_cast<Index>(k),
                         modes.modes[k].frequency_hz),
        motions_at(places, modes, factor * phi));
  }
  return mesh;
}

std::vector<fs::path> vtu_files(const fs::path& named) {
  return {with_ending(named, ".pvd"),
          with_ending(named, "-model.vtu"),
          with_ending(named, "-points.vtu")};
}

void write_shapes_vtu(Session& session,
                      const fs::path& named,
                      const acquisition::OutputRule& rule,
                      const Progress& progress) {
  const Comparison& comparison = session.comparison(progress);
  const structure::Deck& deck = session.deck(progress);
  const std::vector<fs::path> files = vtu_files(named);
  const std::string model = vtu_text(model_mesh(deck, comparison.modes));
  const std::string points =
      vtu_text(points_mesh(deck, session.modes(progress), comparison));
  const std::string whole =
      pvd_text({files[1].filename().string(), files[2].filename().string()});
  acquisition::write_files(
      {{files[0], whole}, {files[1], model}, {files[2], points}}, rule);
}

}  // namespace tapfit::updating
