#include "modal/uff55.hpp"

#include "acquisition/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <fstream>
#include <map>
#include <vector>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;

std::string line_of_text(const std::string& text) {
  std::string line = text.substr(0, 80);
  std::ranges::replace_if(
      line, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return (line.empty() ? "NONE" : line) + "\n";
}

/// Six numbers per line, 13 columns each.
std::string numbers(const std::vector<double>& values) {
  std::string text;
  for (std::size_t k = 0; k < values.size(); ++k) {
    text += fmt::format("{:13.5E}", values[k]);
    if (k % 6 == 5 || k + 1 == values.size()) text += "\n";
  }
  return text;
}

std::string header(const std::string& title) {
  return "    -1\n   151\n" + line_of_text("tapfit") + line_of_text(title) +
         line_of_text("tapfit") + "NONE\nNONE\nNONE\nNONE\n    -1\n" +
         "    -1\n   164\n" +
         fmt::format("{:10d}{:<20s}{:10d}\n", 1, "SI: Meter (newton)", 2) +
         "  1.0000000000000000D+00  1.0000000000000000D+00"
         "  1.0000000000000000D+00\n"
         "  2.7314999999999998D+02\n    -1\n";
}

/// Values of every grid: component 1..n at index 0..n-1.
std::map<int, std::vector<Complex>> by_node(const ModeSet& modes,
                                            const Mode& mode,
                                            std::size_t components) {
  std::map<int, std::vector<Complex>> nodes;
  for (std::size_t k = 0; k < modes.dofs.size(); ++k) {
    std::vector<Complex>& values = nodes[modes.dofs[k].node];
    values.resize(components);
    values[static_cast<std::size_t>(modes.dofs[k].component - 1)] =
        mode.shape(static_cast<Eigen::Index>(k));
  }
  return nodes;
}

std::string dataset_55(const ModeSet& modes,
                       std::size_t index,
                       const std::string& title) {
  const Mode& mode = modes.modes[index];
  const bool rotations = std::ranges::any_of(
      modes.dofs, [](const Dof& dof) { return dof.component > 3; });
  const int components = rotations ? 6 : 3;
  const Complex a =
      modes.scaled ? Complex(0.0, 2.0 * mode.pole.imag()) : Complex(0.0);
  const Complex b = -mode.pole * a;
  std::string text = "    -1\n    55\n" + line_of_text(title);
  text += fmt::format("{:.6g} Hz, damping ratio {:.4g}\n",
                      mode.frequency_hz,
                      mode.damping_ratio);
  text += modes.scaled ? "unit modal mass\n" : "not scaled\n";
  text += "NONE\nNONE\n";
  // Structural model, complex eigenvalue of first order, global vectors,
  // displacement, complex.
  text += fmt::format("{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}\n",
                      1,
                      3,
                      rotations ? 3 : 2,
                      8,
                      5,
                      components);
  text += fmt::format("{:10d}{:10d}{:10d}{:10d}\n", 2, 6, 1, index + 1);
  text += numbers({mode.pole.real(),
                   mode.pole.imag(),
                   a.real(),
                   a.imag(),
                   b.real(),
                   b.imag()});
  for (const auto& [node, values] :
       by_node(modes, mode, static_cast<std::size_t>(components))) {
    text += fmt::format("{:10d}\n", node);
    std::vector<double> parts;
    for (const Complex& value : values) {
      parts.push_back(value.real());
      parts.push_back(value.imag());
    }
    text += numbers(parts);
  }
  return text + "    -1\n";
}

}  // namespace

std::string modes_as_uff(const ModeSet& modes, const std::string& title) {
  std::string text = header(title);
  for (std::size_t k = 0; k < modes.modes.size(); ++k) {
    text += dataset_55(modes, k, title);
  }
  return text;
}

void write_modes_uff(const ModeSet& modes,
                     const std::string& title,
                     const std::filesystem::path& path) {
  std::ofstream file(path, std::ios::binary);
  file << modes_as_uff(modes, title);
  file.close();
  if (!file) {
    throw InputError("cannot write the modes",
                     path.string(),
                     "check that the folder exists and is writable");
  }
}

}  // namespace tapfit::modal
