#include "signal/checks/hit_coherence.hpp"
#include "signal/files/uff58.hpp"
#include "tui/commands/commands.hpp"
#include "tui/commands/free_masses.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/options/standard_streams.hpp"
#include "tui/report/frf_text.hpp"
#include "tui/report/json_text.hpp"
#include "updating/export/point_geometry.hpp"
#include "updating/session/session.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

signal::FrfForm form_of(const std::string& text) {
  if (text == "mobility") return signal::FrfForm::Mobility;
  if (text == "receptance") return signal::FrfForm::Receptance;
  return signal::FrfForm::Accelerance;
}

// Hits that stand apart from their fellows are judged out, as if by hand.
void leave_hits_apart(updating::Session& session, const Progress& progress) {
  const acquisition::HitSet hits = session.hits(progress);
  for (const acquisition::RunGroup& group :
       acquisition::runs_alike(session.bundle())) {
    for (const auto& [run, hit] : signal::hits_apart(signal::group_coherence(
             session.bundle(), session.recordings(), hits, group))) {
      session.overrule_hit(run, hit);
      say(fmt::format(
          "note: {}: hit {} at {:.3f} s stands apart and is left out\n",
          session.bundle().runs[run].file.filename().string(),
          hit + 1,
          hits.runs[run][hit].time_s));
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

// Ready FRFs and modes come without.
bool has_blocks(const updating::Session& session) {
  return !session.bundle().frfs && !session.bundle().modes;
}

std::string block_text(updating::Session& session, const Progress& progress) {
  if (!has_blocks(session)) return {};
  const acquisition::HitSet& hits = session.hits(progress);
  return fmt::format(
      "  blocks of {:.4g} s, {}\n", block_seconds(hits), hits.block_reason);
}

ordered_json with_block(ordered_json frfs,
                        updating::Session& session,
                        const Progress& progress) {
  if (!has_blocks(session)) return frfs;
  const acquisition::HitSet& hits = session.hits(progress);
  frfs["block"] = {{"s", block_seconds(hits)},
                   {"samples", hits.block},
                   {"reason", hits.block_reason}};
  return frfs;
}

}  // namespace

std::string frf_command(const CommandOptions& options,
                        const Progress& progress) {
  updating::Session session = open_bundle(options);
  refuse_modes(session.bundle());
  if (options.frf.best_hits) leave_hits_apart(session, progress);
  if (!options.free.empty()) return free_masses(session, options, progress);
  const signal::FrfSet frfs = frfs_as_asked(session, options.frf, progress);
  const signal::FrfForm form = form_of(options.frf.form);
  if (options.uff) {
    signal::write_frfs_uff(frfs,
                           session.bundle().title,
                           *options.uff,
                           output_rule(session.bundle(), options),
                           form,
                           updating::point_geometry(session));
  }
  if (options.json) {
    return json_text(with_block(frf_json(frfs, form), session, progress));
  }
  return frf_text(frfs, form) + block_text(session, progress);
}

}  // namespace tapfit::tui
