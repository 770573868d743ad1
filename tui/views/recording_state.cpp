#include "tui/views/recording_state.hpp"

#include "signal/frf_set/measured_coherence.hpp"
#include "tui/screen/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

namespace tapfit::tui {

using acquisition::Hit;

namespace {

/// "0.9981 acc1": of the run's FRFs the one with the lowest mean over its
/// lines; "–" where none was measured.
std::string worst_coherence(const RecordingInput& input,
                            const acquisition::Run& run) {
  const auto same = [](const Dof& a, const Dof& b) {
    return a.node == b.node && a.component == b.component;
  };
  double worst = 2.0;
  std::string channel;
  for (const signal::Frf& frf : input.frfs->frfs) {
    if (!signal::has_coherence(frf) || !same(frf.reference, run.hammer.dof)) {
      continue;
    }
    const auto at = std::ranges::find_if(run.sensors, [&](const auto& sensor) {
      return same(sensor.dof, frf.response);
    });
    if (at == run.sensors.end() || frf.coherence.mean() >= worst) continue;
    worst = frf.coherence.mean();
    channel = input.bundle.channels.at(at->channel).name;
  }
  return channel.empty() ? "–" : fmt::format("{} {}", fixed(worst, 4), channel);
}

/// "1 overload, 2 double (kept)".
std::string fault_counts(const std::vector<Hit>& hits) {
  std::map<std::string, int> counts;
  for (const Hit& hit : hits) {
    for (const acquisition::HitFault fault : hit.reasons) {
      ++counts[acquisition::name(fault) + (hit.accepted ? " (kept)" : "")];
    }
  }
  std::string text;
  for (const auto& [fault, count] : counts) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, fault);
  }
  return text;
}

}  // namespace

std::size_t hits_by(const RecordingInput& input,
                    std::size_t run,
                    double time_s) {
  const std::vector<Hit>& hits = input.hits.runs[run];
  const auto complete = [&](const Hit& hit) {
    const Eigen::Index end =
        std::min(hit.begin + input.hits.block, input.traces[run].samples);
    return static_cast<double>(end) <= time_s * input.hits.sample_rate_hz;
  };
  return static_cast<std::size_t>(
      std::count_if(hits.begin(), hits.end(), complete));
}

const acquisition::LeftOut* RecordingInput::not_used(std::size_t run) const {
  if (left_out == nullptr) return nullptr;
  const auto found =
      std::ranges::find(*left_out, run, &acquisition::LeftOut::run);
  return found == left_out->end() ? nullptr : &*found;
}

Table run_table(const RecordingInput& input) {
  Table table{{{"run", true},
               {"file"},
               {"hammer"},
               {"hits", true},
               {"accepted", true},
               {"worst coherence"},
               {"notes"}},
              {},
              true};
  const std::size_t count =
      std::min(input.bundle.runs.size(), input.hits.runs.size());
  for (std::size_t k = 0; k < count; ++k) {
    const acquisition::Run& run = input.bundle.runs[k];
    const std::vector<Hit>& hits = input.hits.runs[k];
    const auto accepted = std::ranges::count(hits, true, &Hit::accepted);
    const acquisition::LeftOut* out = input.not_used(k);
    const bool all = accepted == static_cast<std::ptrdiff_t>(hits.size());
    table.rows.push_back(
        {{fmt::format("{}", k + 1),
          run.file.filename().string(),
          name(run.hammer.dof),
          fmt::format("{}", hits.size()),
          fmt::format("{}", accepted),
          input.frfs == nullptr ? "…" : worst_coherence(input, run),
          out != nullptr ? "left out: " + std::string(out->why.what())
                         : fault_counts(hits)},
         {.colour = out != nullptr ? Colour::Red
                    : all          ? Colour::Default
                                   : Colour::Yellow}});
  }
  return table;
}

}  // namespace tapfit::tui
