#include "acquisition/checks/record_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace tapfit::acquisition {
namespace {

using Records = std::vector<const ChannelRecord*>;

// A sensor's level over the quantisation noise (step / sqrt 12) [dB]. Below it
// quantisation is more than 1 % of the average line of an FRF, and more than
// all of it at an antiresonance 40 dB down.
constexpr double least_over_quantum_db = 40.0;
constexpr double least_hammer_bits = 7.0;  // a blow is then known to 1 %
constexpr double least_range_used = 0.01;  // of full scale: 7 bits given away
// The mean's change from block to block, of the level: a slope of that much
// within a block stands in the lowest lines with a third of it.
constexpr double most_drift = 0.1;

bool is_hammer(const TestBundle& bundle, const ChannelRecord& record) {
  return bundle.runs[record.run].hammer.channel == record.channel;
}

double over_quantum_db(const ChannelRecord& record) {
  const double noise = record.step / std::sqrt(12.0);
  return 20.0 * std::log10(record.level / noise);
}

Subject subject_of(const TestBundle& bundle, const Records& records) {
  Subject where;
  where.channel = bundle.channels[records.front()->channel].name;
  for (const ChannelRecord* record : records) {
    where.runs.push_back(record->run);
  }
  return where;
}

// The worst of them by `measure`, largest.
const ChannelRecord& worst(
    const Records& records,
    const std::function<double(const ChannelRecord&)>& measure) {
  return **std::ranges::max_element(
      records, {}, [&](const auto* record) { return measure(*record); });
}

Finding coarse_finding(const TestBundle& bundle, const Records& records) {
  const ChannelRecord& record =
      worst(records, [](const ChannelRecord& r) { return r.step / r.peak; });
  return {Severity::Warning,
          subject_of(bundle, records),
          is_hammer(bundle, record)
              ? fmt::format("the largest blow fills {:.1f} bits", record.bits())
              : fmt::format("the response stands {:.0f} dB over the steps of "
                            "the converter; its peak fills {:.1f} bits",
                            over_quantum_db(record),
                            record.bits()),
          record.range_used() < 0.1
              ? "the range is too wide for this signal"
              : "the file was written with too few bits (8 for example)",
          record.range_used() < 0.1
              ? "choose a finer range at the front end and measure again"
              : "export the recording with 16 bits or more, or measure again"};
}

Finding range_finding(const TestBundle& bundle, const Records& records) {
  const ChannelRecord& record =
      worst(records, [](const ChannelRecord& r) { return r.range_used(); });
  return {Severity::Note,
          subject_of(bundle, records),
          fmt::format("only {:.2g} % of the range is used",
                      100.0 * record.range_used()),
          "the range is too wide, or full_scale_volts is not that of the file",
          "choose a finer range next time; see full_scale_volts in test.json"};
}

Finding dropout_finding(const TestBundle& bundle, const Records& records) {
  int count = 0;
  for (const ChannelRecord* record : records) count += record->dropouts;
  return {Severity::Warning,
          subject_of(bundle, records),
          fmt::format("the value stands still {} times in the middle of a "
                      "signal, first at {:.3f} s of run {}",
                      count,
                      records.front()->first_dropout_s,
                      records.front()->run + 1),
          "samples were lost: a loose plug, or a computer that was too slow",
          "leave these runs out of `runs`, or reject the hits there (Space on "
          "the Recording screen)"};
}

Finding drift_finding(const TestBundle& bundle, const Records& records) {
  const ChannelRecord& record =
      worst(records, [](const ChannelRecord& r) { return r.drift / r.level; });
  return {Severity::Warning,
          subject_of(bundle, records),
          fmt::format("its zero moves from hit to hit by {} % of the "
                      "response",
                      in_digits(100.0 * record.drift / record.level, 2)),
          "a sensor that warms up, a loose connector or a charge amplifier "
          "that drifts",
          "begin band_hz above the lowest lines, or measure again with a "
          "high-pass filter in the channel"};
}

struct Check {
  std::function<bool(const ChannelRecord&)> fails;
  Finding (*finding)(const TestBundle&, const Records&);
};

std::vector<Check> checks(const TestBundle& bundle) {
  const auto coarse = [&bundle](const ChannelRecord& r) {
    if (!(r.step > 0.0)) return false;
    if (is_hammer(bundle, r)) return r.bits() < least_hammer_bits;
    return r.level > 0.0 && over_quantum_db(r) < least_over_quantum_db;
  };
  return {
      {coarse, coarse_finding},
      {[coarse](const ChannelRecord& r) {
         return std::isfinite(r.full_scale) && !coarse(r) &&
                r.range_used() < least_range_used;
       },
       range_finding},
      {[](const ChannelRecord& r) { return r.dropouts > 0; }, dropout_finding},
      {[&bundle](const ChannelRecord& r) {
         return !is_hammer(bundle, r) && r.level > 0.0 &&
                r.drift > most_drift * r.level;
       },
       drift_finding}};
}

}  // namespace

std::vector<Finding> record_findings(
    const TestBundle& bundle, const std::vector<ChannelRecord>& records) {
  std::vector<Finding> findings;
  for (std::size_t channel = 0; channel < bundle.channels.size(); ++channel) {
    for (const Check& check : checks(bundle)) {
      Records failed;
      for (const ChannelRecord& record : records) {
        if (record.channel == channel && check.fails(record)) {
          failed.push_back(&record);
        }
      }
      if (!failed.empty()) findings.push_back(check.finding(bundle, failed));
    }
  }
  return findings;
}

}  // namespace tapfit::acquisition
