// Writing FRFs to a universal file: datasets 151, 164, then a 58 (and with an
// exponential window a 1858) per FRF.
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/output_file.hpp"
#include "acquisition/uff/uff_header.hpp"
#include "acquisition/uff/uff_systems.hpp"
#include "acquisition/uff/write_uff_geometry.hpp"
#include "signal/files/uff58.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <cmath>
#include <ostream>

namespace tapfit::signal {
namespace {

using acquisition::time_stamp;
using acquisition::write_uff_axis;

constexpr std::string_view fence = acquisition::uff_fence;

int direction(const Dof& dof) { return dof.sign * dof.component; }

bool is_even(const Eigen::VectorXd& f) {
  if (f.size() < 3) return true;
  const double step =
      (f(f.size() - 1) - f(0)) / static_cast<double>(f.size() - 1);
  for (Eigen::Index i = 0; i < f.size(); ++i)
    if (std::abs(f(i) - f(0) - static_cast<double>(i) * step) >
        1e-9 * std::abs(f(f.size() - 1)))
      return false;
  return true;
}

double one_sigma(const FrfSet& set) {
  if (set.lines() == 0) return 0.0;
  const double sigma = set.s(0).real();
  if ((set.s.real().array() - sigma).abs().maxCoeff() >
      1e-9 * (std::abs(sigma) + 1.0))
    throw InputError("the lines have different decay rates",
                     "UFF 58 output",
                     "write FRFs that share one exponential window");
  return sigma;
}

void write_values(const Eigen::VectorXd& f,
                  const Eigen::VectorXcd& H,
                  bool even,
                  std::ostream& out) {
  for (Eigen::Index i = 0; i < H.size(); ++i) {
    if (!even) fmt::print(out, "{:13.5E}", f(i));
    fmt::print(out, "{:20.12E}{:20.12E}", H(i).real(), H(i).imag());
    if (!even || i % 2 == 1 || i + 1 == H.size()) out << '\n';
  }
}

// How a form is named, and what its numerator is.
struct Ordinate {
  std::string_view form;
  int type = 12;
  std::string_view name;
  std::string_view unit;
};

Ordinate ordinate(FrfForm form) {
  if (form == FrfForm::Mobility) return {"Mobility", 11, "Velocity", "m/s"};
  if (form == FrfForm::Receptance)
    return {"Receptance", 8, "Displacement", "m"};
  return {"Accelerance", 12, "Acceleration", "m/s^2"};
}

void write_frf(const FrfSet& set,
               const Frf& frf,
               int number,
               FrfForm form,
               std::ostream& out) {
  const double sigma = one_sigma(set);
  const Ordinate as = ordinate(form);
  const Eigen::VectorXd f = set.frequency_hz();
  const bool even = is_even(f);
  const double step = f.size() > 1 ? (f(f.size() - 1) - f(0)) /
                                         static_cast<double>(f.size() - 1)
                                   : 0.0;
  fmt::print(out,
             "{}    58\n{}\n{} hits, run {}\n{}\n",
             fence,
             fmt::format("{} {}", as.form, name(frf)),
             frf.hits,
             frf.run + 1,
             time_stamp().date + " " + time_stamp().clock);
  if (sigma > 0.0)
    fmt::print(out, "SIGMA = {:.16e} 1/s\n", sigma);
  else
    out << "NONE\n";
  // Record 7 holds six digits only; the exact lines stand here.
  if (even)
    fmt::print(out, "LINES = {:.16e} + n {:.16e} Hz\n", f(0), step);
  else
    out << "NONE\n";
  fmt::print(out,
             "{:5}{:10}{:5}{:10} {:<10}{:10}{:4} {:<10}{:10}{:4}\n",
             4,
             number,
             0,
             0,
             "NONE",
             acquisition::uff_label(frf.response.node),
             direction(frf.response),
             "NONE",
             acquisition::uff_label(frf.reference.node),
             direction(frf.reference));
  fmt::print(out,
             "{:10}{:10}{:10}{:13.5E}{:13.5E}{:13.5E}\n",
             6,
             f.size(),
             even ? 1 : 0,
             f(0),
             even ? step : 0.0,
             0.0);
  write_uff_axis(18, "Frequency", "Hz", out);
  write_uff_axis(as.type, as.name, as.unit, out);
  write_uff_axis(13, "Force", "N", out);
  write_uff_axis(0, "NONE", "NONE", out);
  write_values(f, convert(frf.H, set.s, FrfForm::Accelerance, form), even, out);
  out << fence;
}

// Window type 6: impact and exponential. Damping factor: sigma in 1/s.
void write_qualifiers(const Frf& frf,
                      int number,
                      double sigma,
                      std::ostream& out) {
  fmt::print(out,
             "{}  1858\n{:12}{:12}{:12}{:12}{:12}{:12}\n",
             fence,
             number,
             0,
             frf.run + 1,
             0,
             0,
             0);
  for (const int value : {0, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0})
    fmt::print(out, "{:6}", value);
  out << '\n';
  const std::string zero = fmt::format("{:15.7E}", 0.0);
  fmt::print(out, "{0}{0}{0}{0}{0}\n", zero);
  fmt::print(out, "{0}{0}{0}{0}{1:15.7E}\n", zero, sigma);
  fmt::print(out, "{0}{0}{0}{0}{0}\nNONE  NONE\nNONE\n{1}", zero, fence);
}

}  // namespace

void write_frfs_uff(const FrfSet& set,
                    const std::string& title,
                    std::ostream& out,
                    FrfForm form) {
  const double sigma = one_sigma(set);
  acquisition::write_uff_header(title, "FRFs from a hammer test", out);
  if (set.lines() == 0) return;
  int number = 0;
  for (const Frf& frf : set.frfs) {
    ++number;
    write_frf(set, frf, number, form, out);
    if (sigma > 0.0) write_qualifiers(frf, number, sigma, out);
  }
}

void write_frfs_uff(const FrfSet& set,
                    const std::string& title,
                    const std::filesystem::path& file,
                    const acquisition::OutputRule& rule,
                    FrfForm form,
                    const acquisition::UffGeometry& points) {
  acquisition::OutputFile out(file, rule);
  write_frfs_uff(set, title, out.stream(), form);
  write_geometry(points, acquisition::UffNodes::D2411, out.stream());
  out.commit();
}

}  // namespace tapfit::signal
