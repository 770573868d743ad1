#include "acquisition/uff/uff_shapes.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/uff/uff_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::acquisition {
namespace {

// What the line before the analysis' own numbers says of the data.
struct Form {
  int per_node = 0;
  [[nodiscard]] std::size_t numbers(bool complex) const {
    return static_cast<std::size_t>(per_node) * (complex ? 2 : 1);
  }
};

Form read_form(UffLines& lines, const UffDataset& dataset, UffShape& shape) {
  const std::vector<int> v = lines.integers(6);
  shape.analysis = v[1];
  shape.data_type = v[3];
  shape.complex = v[4] == 5 || v[4] == 6;
  if ((v[4] != 2 && v[4] != 4 && !shape.complex) || v[5] < 1 || v[5] > 64) {
    throw InputError(
        fmt::format(
            "data type {} with {} values a node is not known", v[4], v[5]),
        dataset.place,
        "export real or complex data at nodes");
  }
  return {v[5]};
}

// Eigenvalue and modal A, as far as they are given.
void take_eigenvalue(const std::vector<double>& real, UffShape& shape) {
  const std::complex<double> lambda(real[0], real[1]);
  shape.eigenvalue = lambda;
  if (real.size() > 3) shape.modal_a = {real[2], real[3]};
  const double size = std::abs(lambda);
  shape.frequency_hz = size / (2.0 * std::numbers::pi);
  shape.damping_ratio = size > 0.0 ? -lambda.real() / size : 0.0;
}

void read_analysis_55(UffLines& lines, UffShape& shape) {
  const std::vector<int> header = lines.integers(2);
  const auto count = [](int n) {
    return static_cast<std::size_t>(std::clamp(n, 0, 1000));
  };
  std::vector<int> whole(header.begin() + 2, header.end());
  // More integers than stand behind the two counts go on on the next line.
  if (whole.size() < count(header[0])) {
    const auto rest = lines.many_integers(count(header[0]) - whole.size());
    whole.insert(whole.end(), rest.begin(), rest.end());
  }
  const std::vector<double> real = lines.many(13, count(header[1]));
  if (whole.size() > 1) shape.mode = whole[1];
  const bool complex_mode = shape.analysis == 3 || shape.analysis == 7;
  if (complex_mode && real.size() > 1) {
    take_eigenvalue(real, shape);
  } else if (!real.empty()) {
    shape.frequency_hz = real[0];
    if (real.size() > 1) shape.modal_mass = real[1];
    if (real.size() > 2) shape.damping_ratio = real[2];
    const bool loss = real.size() > 3 && shape.damping_ratio == 0.0;
    if (loss) shape.damping_ratio = 0.5 * real[3];
  }
}

void read_analysis_2414(UffLines& lines, UffShape& shape) {
  const std::vector<int> whole = lines.many_integers(10);
  const std::vector<double> real = lines.many(13, 12);
  shape.mode = whole[5];
  shape.frequency_hz = real[1];
  shape.modal_mass = real[3];
  shape.damping_ratio = real[4] != 0.0 ? real[4] : 0.5 * real[5];
  const bool complex_mode = shape.analysis == 3 || shape.analysis == 7;
  if (complex_mode && (real[6] != 0.0 || real[7] != 0.0)) {
    take_eigenvalue({real.begin() + 6, real.end()}, shape);
  }
}

void read_values(UffLines& lines, const Form& form, UffShape& shape) {
  while (!lines.only_blanks_left()) {
    const int node = lines.integers(1)[0];
    const std::vector<double> v = lines.many(13, form.numbers(shape.complex));
    Eigen::VectorXcd& value = shape.values[node];
    value.resize(form.per_node);
    for (Eigen::Index i = 0; i < value.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      value[i] = shape.complex ? std::complex<double>(v[2 * k], v[2 * k + 1])
                               : std::complex<double>(v[k], 0.0);
    }
  }
}

}  // namespace

bool stands_at_nodes(const UffDataset& dataset) {
  if (dataset.type != 2414) return true;
  UffLines lines(dataset);
  (void)lines.text();
  (void)lines.text();
  return lines.integers(1)[0] == 1;
}

UffShape read_shape(const UffDataset& dataset) {
  if (!stands_at_nodes(dataset)) {
    throw InputError("its data does not stand at nodes",
                     dataset.place,
                     "export data at nodes");
  }
  UffLines lines(dataset);
  UffShape shape;
  for (int skipped = 0; dataset.type == 2414 && skipped < 3; ++skipped) {
    (void)lines.text();
  }
  for (std::string& line : shape.id) line = lines.text();
  const Form form = read_form(lines, dataset, shape);
  if (dataset.type == 2414) {
    read_analysis_2414(lines, shape);
  } else {
    read_analysis_55(lines, shape);
  }
  read_values(lines, form, shape);
  return shape;
}

}  // namespace tapfit::acquisition
