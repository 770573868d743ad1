// The room updating/structure/deck. The finite element model as the deck says
// it.
// Out: Deck: grids, elements, properties, materials, constraints, in the deck's
//      own units or in SI.
// May include: its row in CONTRIBUTING.md.
//
// The finite element model as the deck says it: grids, elements, properties,
// materials, constraints. Reading and writing are in read_deck and write_deck.
#pragma once

#include <Eigen/Core>

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tapfit::structure {

struct Grid {
  int id = 0;
  Eigen::Vector3d position;  ///< basic axes [m]
  /// Displacement axes (CD), columns in basic axes: the components of cards at
  /// this grid count along them.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

/// CQUAD4 (four grids) or CTRIA3 (three).
struct Shell {
  int id = 0;
  int property = 0;
  std::vector<int> grids;
  double theta_deg = 0.0;  ///< material axis from side 1-2
  std::string where = {};  ///< "file:line CARD id"; empty: not from a file
};

/// CBAR (and CBEAM of constant section).
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

/// CROD and CONROD (the latter gets a property of its own, id < 0).
struct Rod {
  int id = 0;
  int property = 0;
  std::array<int, 2> grids{};
  std::string where = {};  ///< "file:line CARD id"; empty: not from a file
};

/// CONM2.
struct PointMass {
  int id = 0;
  int grid = 0;
  double mass = 0.0;                                  ///< [kg]
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();   ///< [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about its centre
};

/// CELAS1/2 (stiffness), CDAMP1/2 (damping), CMASS2 (mass); grid 0 is ground.
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

/// MAT1, or MAT8 (orthotropic) when `orthotropic` is set.
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
};

/// PSHELL. Material ids 0 mean the part is absent.
struct ShellProperty {
  int id = 0;
  int membrane = 0;
  int bending = 0;
  int shear = 0;
  double thickness = 0.0;          ///< [m]
  double bending_ratio = 1.0;      ///< 12 I / t^3
  double shear_ratio = 5.0 / 6.0;  ///< ts / t
  double nonstructural = 0.0;      ///< [kg/m^2]
  std::string where = {};  ///< "file:line CARD id"; empty: not from a file
};

/// PBAR, PBARL, PBEAM of constant section.
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
};

/// PROD, or a CONROD's own section.
struct RodProperty {
  int id = 0;
  int material = 0;
  double area = 0.0;
  double J = 0.0;
  double nonstructural = 0.0;
  std::string where = {};  ///< "file:line CARD id"; empty: not from a file
};

/// SPC, SPC1 and a grid's permanent constraints: components held at zero.
struct Constraint {
  int grid = 0;
  std::string components;  ///< digits of 1..6, along the grid's own axes
};

/// K and M from another program, see matrix_market.hpp.
struct GivenMatrices;

struct Deck {
  std::filesystem::path path;
  std::vector<Grid> grids;  ///< in the deck's order
  std::vector<Shell> shells;
  std::vector<Bar> bars;
  std::vector<Rod> rods;
  std::vector<PointMass> masses;
  std::vector<ScalarElement> scalars;
  std::vector<Bush> bushes;
  std::vector<RigidElement> rigids;
  std::map<int, Material> materials;
  std::map<int, ShellProperty> shell_properties;
  std::map<int, BarProperty> bar_properties;
  std::map<int, RodProperty> rod_properties;
  std::vector<Constraint> constraints;
  std::vector<std::array<int, 2>> plot_lines;  ///< PLOTEL
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
  [[nodiscard]] bool has_grid(int id) const;
};

/// Reads Nastran bulk data: free, small and large field, continuations,
/// `1.5-3` reals, INCLUDE. Unknown cards are kept and warned about.
///
/// @throws InputError with file and line for a card that cannot be read, a
///   reference to a grid, property or material that does not exist
[[nodiscard]] Deck read_deck(const std::filesystem::path& path);

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
void write_deck(const Deck& deck,
                const std::vector<std::string>& added_cards,
                const std::filesystem::path& path);

}  // namespace tapfit::structure
