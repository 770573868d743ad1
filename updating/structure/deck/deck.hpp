// The room updating/structure/deck. The finite element model as the deck says
// it.
// Out: Deck: grids, elements, properties, materials, constraints, in the deck's
//      own units or in SI.
// May include: its row in CONTRIBUTING.md.
//
// The finite element model as the deck says it: grids, elements, properties,
// materials, constraints. Reading and writing are in read_deck and write_deck.
#pragma once

#include "acquisition/foundation/coordinate_system.hpp"
#include "acquisition/foundation/output_rule.hpp"

#include <Eigen/Core>

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tapfit::structure {

struct Grid {
  int id = 0;  ///< below 0: a point of the test's own, see MeasuringPoint
  Eigen::Vector3d position;  ///< basic axes [m]
  /// Displacement axes (CD), columns in basic axes: the components of cards at
  /// this grid count along them.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  /// SPOINT: its one degree of freedom is component 1, the others are held; it
  /// has no place of its own.
  bool scalar = false;
};

/// CQUAD4, CQUADR, CQUAD8 (four corners), CTRIA3, CTRIAR, CTRIA6 (three), and
/// CSHEAR where its property is a panel.
struct Shell {
  int id = 0;
  int property = 0;
  std::vector<int> grids;  ///< corners
  double theta_deg = 0.0;  ///< material axis from side 1-2
  std::string where = {};  ///< "file:line CARD id"; empty: not from a file
  /// Of CQUAD8 and CTRIA6: in the middle of each side, from 1-2 on; 0 where
  /// there is none.
  std::vector<int> mids = {};
  double offset = 0.0;     ///< ZOFFS: reference surface above the grids [m]
  double thickness = 0.0;  ///< mean of the corners'; 0: the property's [m]

  /// Corners and mids that are there.
  [[nodiscard]] std::vector<int> all_grids() const;
};

/// CHEXA (8 corners), CPENTA (6), CPYRAM (5), CTETRA (4).
struct Solid {
  int id = 0;
  int property = 0;
  std::vector<int> grids;      ///< corners, in the order of the card
  std::vector<int> mids = {};  ///< of its edges, in the order of the card;
                               ///< none, or 0 where there is none
  std::string where = {};      ///< "file:line CARD id"

  [[nodiscard]] std::vector<int> all_grids() const;
};

/// CBAR, CBEAM.
struct Bar {
  int id = 0;
  int property = 0;
  std::array<int, 2> grids{};
  Eigen::Vector3d orientation;  ///< basic axes; plane 1 holds it
  std::array<Eigen::Vector3d, 2> offsets{Eigen::Vector3d::Zero(),
                                         Eigen::Vector3d::Zero()};
  std::array<std::string, 2> released;  ///< component digits at each end
  bool rotary_inertia = false;  ///< of cross sections: CBEAM has it, CBAR not
  std::string where = {};       ///< "file:line CARD id"; empty: not from a file
};

/// CROD, CTUBE and CONROD (the latter gets a property of its own, id < 0).
struct Rod {
  int id = 0;
  int property = 0;
  std::array<int, 2> grids{};
  std::string where = {};  ///< "file:line CARD id"; empty: not from a file
};

/// CONM2, CONM1.
struct PointMass {
  int id = 0;
  int grid = 0;
  double mass = 0.0;                                  ///< [kg]
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();   ///< [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about its centre
  /// CONM1: a mass matrix besides, in basic axes; 0 x 0 where there is none.
  Eigen::MatrixXd matrix = {};
};

/// CELAS1-4 and CBUSH1D (stiffness), CDAMP1-4 (damping), CMASS1-4 (mass); grid
/// 0 is ground.
struct ScalarElement {
  int id = 0;
  std::array<int, 2> grids{};
  std::array<int, 2> components{};  ///< 1..6
  double stiffness = 0.0;           ///< [N/m] or [N m/rad]
  double damping = 0.0;             ///< [N s/m]
  double mass = 0.0;                ///< [kg] or [kg m^2]
  /// Direction of the component in basic axes where the grid's displacement
  /// axes (CD) are turned; zero: the basic axis of the component.
  std::array<Eigen::Vector3d, 2> axes{Eigen::Vector3d::Zero(),
                                      Eigen::Vector3d::Zero()};
};

/// CBUSH: springs along and about three axes between two grids (grid 0 is
/// ground), joined to them by rigid arms.
struct Bush {
  int id = 0;
  std::array<int, 2> grids{};
  std::array<Eigen::Vector3d, 2> arms{Eigen::Vector3d::Zero(),
                                      Eigen::Vector3d::Zero()};  ///< [m]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns x, y, z
  std::array<double, 6> stiffness{};  ///< [N/m] three times, [N m/rad]
  std::array<double, 6> damping{};    ///< [N s/m] three times, [N m s/rad]
};

/// A grid's components that follow a rigid element, digits of 1..6.
struct Dependent {
  int grid = 0;
  std::string components;  ///< along the grid's own axes
};

/// RBE2, and RBAR with one end that leads: the dependents move as a rigid body
/// with the independent grid.
struct RigidElement {
  int id = 0;
  int independent = 0;
  std::vector<Dependent> dependents;
  std::string where = {};  ///< "file:line CARD id"; empty: not from a file
};

/// One degree of freedom times a factor.
struct RelationTerm {
  int grid = 0;
  int component = 0;  ///< 1..6, along the grid's own axes
  double factor = 0.0;
};

/// MPC, and each dependent component of an RBE3: a degree of freedom that is a
/// sum of others.
struct Relation {
  int grid = 0;
  int component = 0;  ///< 1..6, along the grid's own axes
  std::vector<RelationTerm> terms;
  std::string where = {};  ///< "file:line CARD id"
};

/// An entry of a symmetric matrix that the deck gives directly (DMIG), and its
/// mirror image.
struct MatrixTerm {
  std::array<int, 2> grids{};
  std::array<int, 2> components{};  ///< 1..6, along the grids' own axes
  double value = 0.0;
};

/// MAT1, or MAT8 (orthotropic) when `orthotropic` is set; MAT2 and MAT9 where
/// their matrix is not zero, E and G then being those along its first axis.
struct Material {
  int id = 0;
  bool orthotropic = false;
  double E = 0.0;    ///< MAT1 [Pa]; E1 of MAT8
  double nu = 0.0;   ///< nu12 of MAT8
  double G = 0.0;    ///< MAT1 [Pa]; G12 of MAT8
  double rho = 0.0;  ///< [kg/m^3]
  double E2 = 0.0;
  double G1z = 0.0;  ///< 0: infinitely stiff in transverse shear
  double G2z = 0.0;
  std::string where = {};  ///< "file:line CARD id"; empty: not from a file
  Eigen::Matrix3d plane = Eigen::Matrix3d::Zero();  ///< MAT2: for (exx, eyy,
                                                    ///< 2 exy) [Pa]
  /// MAT9: for (exx, eyy, ezz, 2 exy, 2 eyz, 2 ezx) [Pa]; empty: none.
  Eigen::MatrixXd solid = {};

  [[nodiscard]] bool is_plane() const { return !plane.isZero(0.0); }
  [[nodiscard]] bool is_solid() const { return solid.size() > 0; }
};

/// A layer of a PCOMP.
struct Ply {
  int material = 0;
  double thickness = 0.0;  ///< [m]
  double theta_deg = 0.0;  ///< from the element's material axis
};

/// PSHELL, PCOMP (with plies), PSHEAR (a panel). Material ids 0 mean the part
/// is absent.
struct ShellProperty {
  int id = 0;
  int membrane = 0;
  int bending = 0;
  int shear = 0;
  double thickness = 0.0;          ///< [m]
  double bending_ratio = 1.0;      ///< 12 I / t^3
  double shear_ratio = 5.0 / 6.0;  ///< ts / t
  double nonstructural = 0.0;      ///< [kg/m^2]
  std::string where = {};       ///< "file:line CARD id"; empty: not from a file
  int coupling = 0;             ///< MID4: between membrane and bending
  std::vector<Ply> plies = {};  ///< from the bottom; instead of the materials
  double bottom = 0.0;          ///< Z0: of the plies, from the reference [m]
  bool bending_alone = false;   ///< of the plies: LAM = BEND
  bool panel = false;           ///< carries shear flow only (CSHEAR)
  /// PSHEAR F1, F2: the share of the panel's area that acts as rods along sides
  /// 1-2 and 2-3.
  std::array<double, 2> extensional{};
};

/// PBAR, PBARL, PBEAM, PBEAML, of the mean section where it changes.
struct BarProperty {
  int id = 0;
  int material = 0;
  double area = 0.0;  ///< [m^2]
  double I1 = 0.0;    ///< bending in plane 1 [m^4]
  double I2 = 0.0;    ///< bending in plane 2 [m^4]
  double I12 = 0.0;
  double J = 0.0;              ///< torsion [m^4]
  double nonstructural = 0.0;  ///< [kg/m]
  double K1 = 0.0;             ///< shear factors; 0: no shear deformation
  double K2 = 0.0;
  std::string where = {};  ///< "file:line CARD id"; empty: not from a file
  /// Of a beam, from its shear centre, along element y and z [m]: where axial
  /// force bends nothing, and where the nonstructural mass is.
  Eigen::Vector2d neutral = Eigen::Vector2d::Zero();
  Eigen::Vector2d nonstructural_at = Eigen::Vector2d::Zero();
  double nonstructural_inertia = 0.0;  ///< about that place [kg m]
};

/// PROD, PTUBE, or a CONROD's own section.
struct RodProperty {
  int id = 0;
  int material = 0;
  double area = 0.0;
  double J = 0.0;
  double nonstructural = 0.0;
  std::string where = {};  ///< "file:line CARD id"; empty: not from a file
};

/// PSOLID.
struct SolidProperty {
  int id = 0;
  int material = 0;
  std::string where = {};  ///< "file:line CARD id"
  /// Axes of a MAT9, columns in basic axes; where they are an element's own
  /// (CORDM -1, blank) `in_element`.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  bool in_element = false;
};

/// SPC, SPC1 and a grid's permanent constraints: components held at zero.
struct Constraint {
  int grid = 0;
  std::string components;  ///< digits of 1..6, along the grid's own axes
};

/// K and M from another program, see matrix_market.hpp.
struct GivenMatrices;

/// A point that a test measures at and the deck does not have: a grid without
/// mass or stiffness whose six components, along axes of its own, follow the
/// grids of the element that holds it (Deck::relations).
struct MeasuringPoint {
  int grid = 0;  ///< its id, below 0
  Eigen::Matrix3d axes =
      Eigen::Matrix3d::Identity();  ///< columns in basic axes
  /// Where the element is that holds it [m]: from there it is on a rigid arm.
  Eigen::Vector3d foot = Eigen::Vector3d::Zero();
  std::string on;      ///< "shell 12", "grid 7"
  int nearest = 0;     ///< grid of the deck
  double to_grid = 0;  ///< its distance [m]
  /// How far the test's coordinates are from the element [m].
  double off = 0.0;
};

/// How the test's own mesh lies on the model: x_model = rotation x_test +
/// translation.
struct LaidOver {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< [m]
  std::size_t pairs = 0;  ///< by which it was found; 0: by best fit
  double rms_m = 0.0;     ///< what is left between them
};

struct Deck {
  std::filesystem::path path;
  std::vector<Grid> grids;  ///< the test's points, then in the deck's order
  std::map<int, CoordinateSystem> systems;  ///< CORD cards, without basic
  std::vector<Shell> shells;
  std::vector<Bar> bars;
  std::vector<Rod> rods;
  std::vector<PointMass> masses;
  std::vector<ScalarElement> scalars;
  std::vector<Bush> bushes;
  std::vector<RigidElement> rigids;
  std::vector<Solid> solids;
  std::vector<Relation> relations;
  std::vector<MatrixTerm> stiffness_terms;  ///< DMIG named by K2GG
  std::vector<MatrixTerm> mass_terms;       ///< DMIG named by M2GG
  std::map<int, Material> materials;
  std::map<int, ShellProperty> shell_properties;
  std::map<int, BarProperty> bar_properties;
  std::map<int, RodProperty> rod_properties;
  std::map<int, SolidProperty> solid_properties;
  std::vector<Constraint> constraints;
  std::vector<std::array<int, 2>> plot_lines;  ///< PLOTEL
  std::vector<MeasuringPoint> measuring;
  std::optional<LaidOver> laid_over;
  bool coupled_mass = false;        ///< PARAM,COUPMASS: consistent mass
  double weight_to_mass = 1.0;      ///< PARAM,WTMASS
  double structural_damping = 0.0;  ///< PARAM,G
  /// What the file's own units are in SI; the numbers here are, once
  /// scale_to_si() has been.
  double file_length_m = 1.0;
  double file_mass_kg = 1.0;
  std::shared_ptr<const GivenMatrices> given;  ///< instead of elements
  std::vector<std::string> cards;     ///< the file as read, line by line, with
                                      ///< INCLUDE files inlined
  std::vector<std::string> warnings;  ///< unknown cards: line, consequence

  [[nodiscard]] std::size_t element_count() const;

  /// Index into `grids`.
  /// @throws InputError for an id that is not there
  [[nodiscard]] std::size_t grid_index(int id) const;
  [[nodiscard]] const Grid& grid(int id) const { return grids[grid_index(id)]; }
  /// Where grids are, in the order of the ids [m].
  [[nodiscard]] std::vector<Eigen::Vector3d> positions(
      std::span<const int> ids) const;
  /// The same, a row each.
  [[nodiscard]] Eigen::MatrixX3d position_rows(std::span<const int> ids) const;
  [[nodiscard]] bool has_grid(int id) const;
};

/// Reads Nastran bulk data: free, small and large field, continuations,
/// `1.5-3` reals, INCLUDE. Cards that change nothing of the modes are listed in
/// one warning.
///
/// @param ignored names of cards that are left out with a warning though they
///   carry stiffness, mass or a constraint
/// @throws InputError with file and line for a card that cannot be read, a
///   reference to a grid, property or material that does not exist, a card
///   without which the model lacks something and that is not supported
[[nodiscard]] Deck read_deck(const std::filesystem::path& path,
                             const std::vector<std::string>& ignored = {});

/// Where an error says that an element or property is.
/// @param where its `where`
/// @param name for one that is from no file, for example "shell 3"
[[nodiscard]] std::string card_place(const Deck& deck,
                                     const std::string& where,
                                     const std::string& name);

/// Throws InputError for every reference to a grid, property or material that
/// does not exist; for decks that were put together by a program.
void check_references(const Deck& deck);

/// Writes the deck's original lines, INCLUDE files inlined, followed by the
/// cards given (for example a CONM2 for an identified mass) before ENDDATA.
/// @throws InputError where the rule does not let it, or it cannot be written
void write_deck(const Deck& deck,
                const std::vector<std::string>& added_cards,
                const std::filesystem::path& path,
                const acquisition::OutputRule& rule);

}  // namespace tapfit::structure
