#include "tui/commands/frf_command.hpp"

#include "signal/checks/hit_coherence.hpp"
#include "signal/files/uff58.hpp"
#include "tui/commands/free_masses.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/report/text_table.hpp"
#include "updating/session/session.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

const char* word(signal::FrfForm form) {
  if (form == signal::FrfForm::Mobility) return "mobility";
  if (form == signal::FrfForm::Receptance) return "receptance";
  return "accelerance";
}

const char* unit(signal::FrfForm form) {
  if (form == signal::FrfForm::Mobility) return "(m/s)/N";
  if (form == signal::FrfForm::Receptance) return "m/N";
  return "(m/s^2)/N";
}

signal::FrfForm form_of(const std::string& text) {
  if (text == "mobility") return signal::FrfForm::Mobility;
  if (text == "receptance") return signal::FrfForm::Receptance;
  return signal::FrfForm::Accelerance;
}

double mean_coherence(const signal::Frf& frf) {
  return frf.coherence.size() > 0 ? frf.coherence.mean() : 0.0;
}

// A single hit's is 1 whatever it is worth.
std::string coherence_text(const signal::Frf& frf) {
  if (frf.coherence.size() == 0 || frf.hits == 1) return "-";
  return fmt::format("{:.4f}", mean_coherence(frf));
}

}  // namespace

double median_sd_percent(const signal::Frf& frf) {
  std::vector<double> percents;
  for (Eigen::Index line = 0; line < frf.variance.size(); ++line) {
    const double magnitude = std::abs(frf.H(line));
    if (magnitude > 0.0) {
      percents.push_back(100.0 * std::sqrt(frf.variance(line)) / magnitude);
    }
  }
  if (percents.empty()) return 0.0;
  const auto middle =
      percents.begin() + static_cast<std::ptrdiff_t>(percents.size() / 2);
  std::nth_element(percents.begin(), middle, percents.end());
  return *middle;
}

ordered_json frf_json(const signal::FrfSet& frfs, signal::FrfForm form) {
  ordered_json list = ordered_json::array();
  for (const auto& frf : frfs.frfs) {
    list.push_back({{"response", name(frf.response)},
                    {"reference", name(frf.reference)},
                    {"type", word(form)},
                    {"unit", unit(form)},
                    {"lines", frfs.lines()},
                    {"mean_coherence", mean_coherence(frf)},
                    {"median_sd_percent", median_sd_percent(frf)},
                    {"run", frf.run + 1},
                    {"hits", frf.hits}});
  }
  return {{"frfs", std::move(list)}, {"statements", frfs.statements}};
}

std::string frf_text(const signal::FrfSet& frfs, signal::FrfForm form) {
  std::string text = fmt::format("FRFs: {}", frfs.frfs.size());
  if (frfs.lines() > 0) {
    const Eigen::VectorXd hz = frfs.frequency_hz();
    text += fmt::format(", {} [{}] on {} lines, {:.4g} to {:.4g} Hz",
                        word(form),
                        unit(form),
                        frfs.lines(),
                        hz(0),
                        hz(hz.size() - 1));
    if (const double sigma = frfs.s(0).real(); sigma > 0.0) {
      text += fmt::format(", exponential window {:.3g} 1/s", sigma);
    }
  }
  TextTable table(
      {"<response / reference", "run", "hits", "coherence", "median sd"});
  for (const auto& frf : frfs.frfs) {
    table.add({name(frf),
               fmt::format("{}", frf.run + 1),
               fmt::format("{}", frf.hits),
               coherence_text(frf),
               percent(median_sd_percent(frf) / 100.0)});
  }
  text += "\n" + table.text();
  for (const auto& statement : frfs.statements) {
    text += "  note: " + statement + "\n";
  }
  return text;
}

namespace {

// Hits that stand apart from their fellows are judged out, as if by hand.
void leave_hits_apart(updating::Session& session, const Progress& progress) {
  const acquisition::HitSet hits = session.hits(progress);
  for (const acquisition::RunGroup& group :
       acquisition::runs_alike(session.bundle())) {
    for (const auto& [run, hit] : signal::hits_apart(signal::group_coherence(
             session.bundle(), session.recordings(), hits, group))) {
      session.overrule_hit(run, hit);
      fmt::print(stderr,
                 "note: {}: hit {} at {:.3f} s stands apart and is left out\n",
                 session.bundle().runs[run].file.filename().string(),
                 hit + 1,
                 hits.runs[run][hit].time_s);
    }
  }
}

// As the session has them where nothing else was asked for.
signal::FrfSet frfs_as_asked(updating::Session& session,
                             const FrfArguments& asked,
                             const Progress& progress) {
  const bool as_usual =
      asked.estimator == "H1" && !asked.window && !asked.sigma;
  if (as_usual || session.bundle().frfs) return session.frfs(progress);
  signal::FrfOptions options;
  if (asked.estimator == "H2") options.estimator = signal::Estimator::H2;
  if (asked.estimator == "Hv") options.estimator = signal::Estimator::Hv;
  if (asked.window) options.window.end_value = *asked.window;
  if (asked.sigma) {
    const auto& hits = session.hits(progress);
    const double block_s = static_cast<double>(hits.block - hits.pre_trigger) /
                           hits.sample_rate_hz;
    options.window.end_value = std::exp(-*asked.sigma * block_s);
  }
  return session.frfs_as(options, progress);
}

double block_seconds(const acquisition::HitSet& hits) {
  return static_cast<double>(hits.block) / hits.sample_rate_hz;
}

// Ready FRFs come without blocks.
std::string block_text(updating::Session& session, const Progress& progress) {
  if (session.bundle().frfs) return {};
  const acquisition::HitSet& hits = session.hits(progress);
  return fmt::format(
      "  blocks of {:.4g} s, {}\n", block_seconds(hits), hits.block_reason);
}

ordered_json with_block(ordered_json frfs,
                        updating::Session& session,
                        const Progress& progress) {
  if (session.bundle().frfs) return frfs;
  const acquisition::HitSet& hits = session.hits(progress);
  frfs["block"] = {{"s", block_seconds(hits)},
                   {"samples", hits.block},
                   {"reason", hits.block_reason}};
  return frfs;
}

}  // namespace

std::string frf_command(const CommandOptions& options,
                        const Progress& progress) {
  updating::Session session = open_bundle(options.input);
  if (options.frf.best_hits) leave_hits_apart(session, progress);
  if (!options.free.empty()) return free_masses(session, options, progress);
  const signal::FrfSet frfs = frfs_as_asked(session, options.frf, progress);
  const signal::FrfForm form = form_of(options.frf.form);
  if (options.uff) {
    signal::write_frfs_uff(frfs, session.bundle().title, *options.uff, form);
  }
  if (options.json) {
    return with_block(frf_json(frfs, form), session, progress).dump(2) + "\n";
  }
  return frf_text(frfs, form) + block_text(session, progress);
}

}  // namespace tapfit::tui
