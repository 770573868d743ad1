#include "updating/structure/elements/laminate.hpp"

#include "updating/structure/elements/ply_stiffness.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

namespace tapfit::structure {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

// A ply along the element's axes.
struct Layer {
  double from = 0.0;  // heights of its faces
  double to = 0.0;
  Eigen::Matrix3d Q;
  Eigen::Matrix2d flexible;  // [1/Pa]
  double rho = 0.0;
};

std::vector<Layer> layers_of(const Deck& deck,
                             const Shell& shell,
                             const ShellProperty& p) {
  double written = 0.0;
  for (const Ply& ply : p.plies) written += ply.thickness;
  const double scale =
      (shell.thickness > 0.0 ? shell.thickness : p.thickness) / written;
  std::vector<Layer> layers;
  double z = p.bottom * scale;
  for (const Ply& ply : p.plies) {
    const Material& m = layer_material(deck, ply.material, shell);
    const double angle = (shell.theta_deg + ply.theta_deg) * degree;
    const Eigen::Matrix3d T = strain_rotation(angle);
    const double top = z + ply.thickness * scale;
    layers.push_back({z,
                      top,
                      T.transpose() * plane_stress(m) * T,
                      transverse_compliance(m, angle),
                      m.rho});
    z = top;
  }
  return layers;
}

// Compliance of transverse shear along one axis.
double shear_compliance(const std::vector<Layer>& layers, Eigen::Index axis) {
  double EA = 0.0;
  double ES = 0.0;
  for (const Layer& layer : layers) {
    const double Q = layer.Q(axis, axis);
    EA += Q * (layer.to - layer.from);
    ES += 0.5 * Q * (layer.to * layer.to - layer.from * layer.from);
  }
  const double neutral = ES / EA;
  double EI = 0.0;
  double g = 0.0;  // at the ply's lower face
  double sum = 0.0;
  for (const Layer& layer : layers) {
    const double Q = layer.Q(axis, axis);
    const double a = layer.from - neutral;
    const double b = layer.to - neutral;
    EI += Q * (b * b * b - a * a * a) / 3.0;
    // Boole's rule, exact for the fourth degree of g^2.
    constexpr std::array<double, 5> boole{7, 32, 12, 32, 7};
    const double at_a = g;
    for (std::size_t k = 0; k < boole.size(); ++k) {
      const double z = a + (b - a) * static_cast<double>(k) / 4.0;
      const double here = at_a + 0.5 * Q * (a * a - z * z);
      sum += boole.at(k) / 90.0 * (b - a) * here * here *
             layer.flexible(axis, axis);
      g = here;
    }
  }
  return sum / (EI * EI);
}

}  // namespace

ShellSection laminate_section(const Deck& deck,
                              const Shell& shell,
                              const ShellProperty& p) {
  ShellSection section;
  section.membrane.setZero();
  section.coupling.setZero();
  section.bending.setZero();
  section.shear_compliance.setZero();
  section.mass = p.nonstructural;
  const std::vector<Layer> layers = layers_of(deck, shell, p);
  const double middle = 0.5 * (layers.front().from + layers.back().to);
  for (const Layer& layer : layers) {
    const double a = layer.from;
    const double b = layer.to;
    section.membrane += layer.Q * (b - a);
    section.coupling += layer.Q * (b * b - a * a) / 2.0;
    section.bending += layer.Q * (b * b * b - a * a * a) / 3.0;
    section.mass += layer.rho * (b - a);
    section.rotary +=
        layer.rho * (std::pow(b - middle, 3) - std::pow(a - middle, 3)) / 3.0;
  }
  for (const Eigen::Index axis : {0, 1}) {
    section.shear_compliance(axis, axis) = shear_compliance(layers, axis);
  }
  // Symmetric plies leave rounding.
  const double t = layers.back().to - layers.front().from;
  if (section.coupling.norm() < 1e-12 * t * section.membrane.norm()) {
    section.coupling.setZero();
  }
  if (p.shear_ratio == 0.0) {
    section.coupling.setZero();
    section.bending = section.membrane * t * t / 12.0;
    section.shear_compliance.setZero();
  }
  if (p.bending_ratio == 0.0) {
    section.coupling.setZero();
    section.bending.setZero();
    section.shear_compliance.setZero();
  }
  if (p.bending_alone) {
    section.membrane.setZero();
    section.coupling.setZero();
    section.shear_compliance.setZero();
  }
  return section;
}

}  // namespace tapfit::structure
