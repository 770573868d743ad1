#include "acquisition/instruments/tdms_scale.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::acquisition {
namespace {

class Scales {
 public:
  Scales(const TdmsObject& channel, const std::filesystem::path& file)
      : channel_(channel), file_(file) {}

  [[nodiscard]] int count() const {
    constexpr double most_scales = 100;
    const auto count = find_number("NI_Number_Of_Scales");
    if (!count || find_text("NI_Scaling_Status") == "scaled") return 0;
    return static_cast<int>(std::clamp(*count, 0.0, most_scales));
  }

  // What scale k makes of the counts.
  // NOLINTNEXTLINE(misc-no-recursion): a scale takes earlier ones only
  [[nodiscard]] Eigen::ArrayXXd scaled(int k,
                                       const Eigen::ArrayXXd& counts) const {
    const std::string prefix = fmt::format("NI_Scale[{}]_", k);
    const std::string kind = find_text(prefix + "Scale_Type");
    if (kind != "Linear" && kind != "Polynomial") refuse(prefix, kind);
    const std::string own = prefix + kind + "_";
    const auto source = find_number(own + "Input_Source");
    const bool raw = !source || !(*source >= 0 && *source < k);
    const Eigen::ArrayXXd x =
        raw ? counts : scaled(static_cast<int>(*source), counts);
    if (kind == "Linear") {
      return number(own + "Slope") * x + number(own + "Y_Intercept");
    }
    Eigen::ArrayXXd y = Eigen::ArrayXXd::Zero(x.rows(), x.cols());
    for (int c = degree(own); c >= 0; --c) {
      y = y * x + number(fmt::format("{}Coefficients[{}]", own, c));
    }
    return y;
  }

 private:
  [[nodiscard]] int degree(const std::string& own) const {
    constexpr double most_coefficients = 64;
    const double size = number(own + "Coefficients_Size");
    return static_cast<int>(std::clamp(size, 0.0, most_coefficients)) - 1;
  }
  [[nodiscard]] std::optional<double> find_number(
      const std::string& name) const {
    const auto found = channel_.properties.find(name);
    if (found == channel_.properties.end()) return std::nullopt;
    const double* value = std::get_if<double>(&found->second);
    return value == nullptr || !std::isfinite(*value) ? std::nullopt
                                                      : std::optional(*value);
  }
  [[nodiscard]] std::string find_text(const std::string& name) const {
    const auto found = channel_.properties.find(name);
    if (found == channel_.properties.end()) return {};
    const std::string* text = std::get_if<std::string>(&found->second);
    return text == nullptr ? std::string() : *text;
  }
  [[nodiscard]] double number(const std::string& name) const {
    const auto value = find_number(name);
    if (!value) refuse(name, "");
    return *value;
  }
  [[noreturn]] void refuse(const std::string& name,
                           const std::string& kind) const {
    throw InputError(
        fmt::format("{} holds unscaled values, and its scale {} is {}",
                    channel_.path,
                    name,
                    kind.empty() ? "not there" : "of kind " + kind),
        file_.string(),
        "save it in LabVIEW or DIAdem as TDMS with scaled values, or as CSV");
  }

  const TdmsObject& channel_;
  const std::filesystem::path& file_;
};

}  // namespace

void apply_tdms_scales(const TdmsObject& channel,
                       const std::filesystem::path& file,
                       Eigen::MatrixXd& values) {
  const Scales scales(channel, file);
  const int count = scales.count();
  if (count == 0) return;
  values = scales.scaled(count - 1, values.array()).matrix();
}

}  // namespace tapfit::acquisition
