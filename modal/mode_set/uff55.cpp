#include "modal/mode_set/uff55.hpp"

#include "acquisition/foundation/output_file.hpp"
#include "acquisition/uff/uff_systems.hpp"
#include "acquisition/uff/write_uff_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <complex>
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
    std::vector<Complex>& values =
        nodes[acquisition::uff_label(modes.dofs[k].node)];
    values.resize(components);
    values[static_cast<std::size_t>(modes.dofs[k].component - 1)] =
        mode.shape(static_cast<Eigen::Index>(k));
  }
  return nodes;
}

/// Re and Im of lambda, modal A and modal B; zeros where the scale is unknown.
std::string eigenvalue(const ModeSet& modes, const Mode& mode) {
  const Complex a =
      modes.scaled ? Complex(0.0, 2.0 * mode.pole.imag()) : Complex(0.0);
  const Complex b = -mode.pole * a;
  return numbers({mode.pole.real(),
                  mode.pole.imag(),
                  a.real(),
                  a.imag(),
                  b.real(),
                  b.imag()});
}

std::string id_lines(const ModeSet& modes,
                     const Mode& mode,
                     const std::string& title) {
  return line_of_text(title) +
         fmt::format("{:.6g} Hz, damping ratio {:.4g}\n",
                     mode.frequency_hz,
                     mode.damping_ratio) +
         (modes.scaled ? "unit modal mass\n" : "not scaled\n") + "NONE\nNONE\n";
}

bool has_rotations(const ModeSet& modes) {
  return std::ranges::any_of(modes.dofs,
                             [](const Dof& dof) { return dof.component > 3; });
}

/// Structural model, complex eigenvalue of first order, three or six values of
/// displacement per grid, complex: record 6 of a 55 and record 9 of a 2414.
std::string kind(bool rotations) {
  return fmt::format("{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}\n",
                     1,
                     3,
                     rotations ? 3 : 2,
                     8,
                     5,
                     rotations ? 6 : 3);
}

std::string values_at_grids(const ModeSet& modes, const Mode& mode) {
  std::string text;
  for (const auto& [node, values] :
       by_node(modes, mode, has_rotations(modes) ? 6 : 3)) {
    text += fmt::format("{:10d}\n", node);
    std::vector<double> parts;
    for (const Complex& value : values) {
      parts.push_back(value.real());
      parts.push_back(value.imag());
    }
    text += numbers(parts);
  }
  return text;
}

std::string dataset_55(const ModeSet& modes,
                       std::size_t index,
                       const std::string& title) {
  const Mode& mode = modes.modes[index];
  return "    -1\n    55\n" + id_lines(modes, mode, title) +
         kind(has_rotations(modes)) +
         fmt::format("{:10d}{:10d}{:10d}{:10d}\n", 2, 6, 1, index + 1) +
         eigenvalue(modes, mode) + values_at_grids(modes, mode) + "    -1\n";
}

std::string dataset_2414(const ModeSet& modes,
                         std::size_t index,
                         const std::string& title) {
  const Mode& mode = modes.modes[index];
  std::string integers;
  for (const std::size_t value :
       std::vector<std::size_t>{0, 0, 0, 0, 1, index + 1, 0, 0}) {
    integers += fmt::format("{:10d}", value);
  }
  // Label, name, data at nodes; then who made it and what it is.
  return "    -1\n  2414\n" +
         fmt::format("{:10d}\nmode {}\n{:10d}\n", index + 1, index + 1, 1) +
         id_lines(modes, mode, title) + kind(has_rotations(modes)) + integers +
         fmt::format("\n{:10d}{:10d}\n", 0, 0) +
         numbers({0.0,
                  mode.frequency_hz,
                  0.0,
                  modes.scaled ? 1.0 : 0.0,
                  mode.damping_ratio,
                  0.0}) +
         eigenvalue(modes, mode) + values_at_grids(modes, mode) + "    -1\n";
}

}  // namespace

std::string modes_as_uff(const ModeSet& modes,
                         const std::string& title,
                         ModeDataset as) {
  std::string text = header(title);
  for (std::size_t k = 0; k < modes.modes.size(); ++k) {
    text += as == ModeDataset::Uff55 ? dataset_55(modes, k, title)
                                     : dataset_2414(modes, k, title);
  }
  return text;
}

void write_modes_uff(const ModeSet& modes,
                     const std::string& title,
                     const std::filesystem::path& path,
                     const acquisition::OutputRule& rule,
                     ModeDataset as,
                     const acquisition::UffGeometry& points) {
  acquisition::OutputFile file(path, rule);
  file.stream() << modes_as_uff(modes, title, as);
  write_geometry(points, acquisition::UffNodes::D2411, file.stream());
  file.commit();
}

}  // namespace tapfit::modal
