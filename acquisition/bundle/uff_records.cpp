#include "acquisition/bundle/uff_records.hpp"

#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/uff/uff_datasets.hpp"
#include "acquisition/uff/uff_header.hpp"
#include "acquisition/uff/uff_systems.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <vector>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

/// How a quantity is named in a universal file.
struct Ordinate {
  int type;
  const char* name;
  const char* unit;
};

Ordinate ordinate_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::Force:
      return {13, "Force", "N"};
    case Quantity::Velocity:
      return {11, "Velocity", "m/s"};
    case Quantity::Displacement:
      return {8, "Displacement", "m"};
    case Quantity::Acceleration:
      break;
  }
  return {12, "Acceleration", "m/s^2"};
}

std::string id_lines(const TestBundle& bundle,
                     const Channel& channel,
                     double rate) {
  std::string text =
      uff_line(fmt::format("channel {} of {}", channel.name, bundle.title)) +
      '\n';
  const TimeStamp now = time_stamp();
  text += fmt::format("written {} {}\n", now.date, now.clock);
  const double full_scale = std::abs(channel.full_scale_si());
  text += std::isfinite(full_scale)
              ? fmt::format("FULL SCALE = {:.16e}\n", full_scale)
              : "NONE\n";
  text += bundle.band_hz ? fmt::format("BAND = {:.16e} TO = {:.16e} Hz\n",
                                       (*bundle.band_hz)[0],
                                       (*bundle.band_hz)[1])
                         : "NONE\n";
  return text + fmt::format("RATE = {:.16e} Hz\n", rate);
}

// Eight bytes a number, the lowest first, whatever the machine's own order.
void write_bytes(const Eigen::Ref<const Eigen::VectorXd>& x,
                 std::ostream& out) {
  constexpr Index at_once = 1 << 14;
  std::vector<char> bytes;
  for (Index done = 0; done < x.size(); done += at_once) {
    const Index count = std::min(at_once, x.size() - done);
    bytes.resize(static_cast<std::size_t>(8 * count));
    for (Index i = 0; i < count; ++i) {
      const auto bits = std::bit_cast<std::uint64_t>(x[done + i]);
      for (int b = 0; b < 8; ++b) {
        bytes[static_cast<std::size_t>(8 * i + b)] =
            static_cast<char>((bits >> (8 * b)) & 0xFF);
      }
    }
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  out << '\n';
}

void write_text(const Eigen::Ref<const Eigen::VectorXd>& x, std::ostream& out) {
  fmt::memory_buffer line;
  for (Index i = 0; i < x.size(); ++i) {
    fmt::format_to(std::back_inserter(line), "{:20.12E}", x[i]);
    if (i % 4 != 3 && i + 1 < x.size()) continue;
    line.push_back('\n');
    out.write(line.data(), static_cast<std::streamsize>(line.size()));
    line.clear();
  }
}

void write_record(const TestBundle& bundle,
                  const Placement& at,
                  const Recording& recording,
                  UffEncoding encoding,
                  int number,
                  std::ostream& out) {
  const Channel& channel = bundle.channels.at(at.channel);
  const auto x = recording.samples.col(static_cast<Index>(at.channel));
  const double rate = recording.sample_rate_hz;
  out << uff_fence;
  if (encoding == UffEncoding::Binary) {
    // Little endian, IEEE 754, 11 lines of text, bytes behind them.
    fmt::print(out,
               "{:6}b{:6}{:6}{:12}{:12}{:6}{:6}{:12}{:12}\n",
               58,
               1,
               2,
               11,
               8 * x.size(),
               0,
               0,
               0,
               0);
  } else {
    fmt::print(out, "{:6}\n", 58);
  }
  out << id_lines(bundle, channel, rate);
  fmt::print(out,
             "{:5}{:10}{:5}{:10} {:<10}{:10}{:4} {:<10}{:10}{:4}\n",
             1,
             number,
             0,
             0,
             "NONE",
             uff_label(at.dof.node),
             at.dof.sign * at.dof.component,
             "NONE",
             0,
             0);
  fmt::print(out,
             "{:10}{:10}{:10}{:13.5E}{:13.5E}{:13.5E}\n",
             4,
             x.size(),
             1,
             0.0,
             1.0 / rate,
             0.0);
  const Ordinate as = ordinate_of(channel.quantity);
  write_uff_axis(17, "Time", "s", out);
  write_uff_axis(as.type, as.name, as.unit, out);
  write_uff_axis(0, "NONE", "NONE", out);
  write_uff_axis(0, "NONE", "NONE", out);
  if (encoding == UffEncoding::Binary) {
    write_bytes(x, out);
  } else {
    write_text(x, out);
  }
  out << uff_fence;
}

}  // namespace

void write_uff_run(const TestBundle& bundle,
                   const Run& run,
                   const Recording& recording,
                   UffEncoding encoding,
                   int& number,
                   std::ostream& out) {
  write_record(bundle, run.hammer, recording, encoding, number++, out);
  for (const Placement& sensor : run.sensors) {
    write_record(bundle, sensor, recording, encoding, number++, out);
  }
}

void write_uff_records(const TestBundle& bundle,
                       UffEncoding encoding,
                       std::ostream& out,
                       const Progress& progress) {
  write_uff_header(bundle.title, "time records of a hammer test", out);
  int number = 1;
  double done = 0.0;
  for (const Run& run : bundle.runs) {
    progress("writing", done++ / static_cast<double>(bundle.runs.size()));
    write_uff_run(
        bundle, run, read_recording(bundle, run), encoding, number, out);
  }
}

}  // namespace tapfit::acquisition
