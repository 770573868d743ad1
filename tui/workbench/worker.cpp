#include "tui/workbench/worker.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "modal/poles/cmif.hpp"
#include "tui/screen/number.hpp"
#include "tui/workbench/diagnosed_effects.hpp"
#include "updating/diagnosis/candidate.hpp"
#include "updating/fit/fit_observer.hpp"
#include "updating/fit/live_fit.hpp"
#include "updating/localisation/signature.hpp"
#include "updating/session/added_effect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <csignal>
#include <exception>
#include <sys/resource.h>
#include <unistd.h>
#include <utility>

namespace tapfit::tui {
namespace {

template <class T>
std::shared_ptr<const T> shared(T value) {
  return std::make_shared<const T>(std::move(value));
}

std::string taken_up(const Snapshot& known) {
  const std::size_t hits = overruled_now(known.hit_acts.done).size();
  if (known.effects.empty() && hits == 0) return {};
  std::vector<std::string> parts;
  const auto on = static_cast<std::size_t>(
      std::ranges::count(known.effects, true, &updating::AddedEffect::on));
  if (on > 0) parts.push_back(effects_text(on) + " added");
  if (on < known.effects.size()) {
    parts.push_back(effects_text(known.effects.size() - on) + " switched off");
  }
  if (hits > 0) {
    parts.push_back(
        fmt::format("{} hit{} judged manually", hits, hits == 1 ? "" : "s"));
  }
  return fmt::format("as left last time: {}", fmt::join(parts, ", "));
}

/// What is worked at again is noted where it was last.
void note_done(std::vector<std::string>& done, const std::string& stage) {
  std::erase(done, stage);
  done.push_back(stage);
}

/// The thread that reads keys and draws goes first where cores are scarce. On
/// Linux a thread has a nice value of its own, and threads started from it
/// take that over.
void go_behind_the_keyboard() {
  constexpr int behind = 5;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), behind);
}

/// Those that come from outside; faults still hit the thread that made them.
/// Threads started from this one take it over.
void leave_signals_to_the_terminal() {
  sigset_t from_outside;
  sigemptyset(&from_outside);
  for (const int number : {SIGHUP,
                           SIGINT,
                           SIGQUIT,
                           SIGTERM,
                           SIGTSTP,
                           SIGCONT,
                           SIGWINCH,
                           SIGPIPE}) {
    sigaddset(&from_outside, number);
  }
  pthread_sigmask(SIG_BLOCK, &from_outside, nullptr);
}

void make_model(Workbench& bench, Snapshot& known, const Progress& progress) {
  known.deck = shared(bench.deck(progress));
  known.wire = shared(wireframe(*known.deck));
}

Eigen::MatrixXd indicator(const signal::FrfSet& frfs) {
  if (frfs.frfs.empty()) return {};
  try {
    Eigen::MatrixXd values = modal::cmif(frfs);
    if (values.rows() == frfs.lines() && values.cols() > 0) return values;
  } catch (const InputError&) {  // too little for it; the sum always is
  }
  return modal::summed_frf(frfs);
}

void make_traces(Workbench& bench, Snapshot& known, const Progress& progress) {
  std::vector<Trace> traces;
  for (const acquisition::Recording& r : bench.recordings(progress)) {
    traces.push_back(trace(r));
  }
  known.traces = shared(std::move(traces));
}

// Of the model as it is, and of the base model.
void take_known_diagnoses(Workbench& bench,
                          Snapshot& known,
                          const Progress& progress) {
  const Snapshot::Effects now = known.effects_on();
  for (const Snapshot::Effects& effects : {now, Snapshot::Effects{}}) {
    if (known.diagnosis_of(effects)) continue;
    auto found = bench.known_diagnosis(effects.size(), progress);
    if (!found) continue;
    if (effects == now) {
      known.diagnosis = shared(*std::move(found));
    } else {
      known.diagnoses.emplace_back(effects, shared(*std::move(found)));
    }
  }
}

void make_evidence(Workbench& bench,
                   Snapshot& known,
                   const Need& need,
                   const Progress& progress) {
  const auto at = static_cast<std::size_t>(need.node);
  if (need.stage == Stage::EffectEvidence) {
    const bool uncertain = need.node == of_uncertain;
    known.effect_evidence[need.node] = shared(bench.evidence(
        uncertain ? updating::EffectRef{updating::uncertain_rung, {}}
                  : known.effects.at(at).ref,
        {},
        progress));
    return;
  }
  const updating::Diagnosis& d = *known.diagnosis;
  const updating::Candidate& candidate = d.candidates.at(at);
  known.candidate_evidence[need.node] = shared(
      bench.evidence(ref_of(candidate), found_with(d, candidate), progress));
}

void make_result(Workbench& bench,
                 Snapshot& known,
                 const Need& need,
                 const Progress& progress) {
  switch (need.stage) {
    case Stage::Model:
      return make_model(bench, known, progress);
    case Stage::Traces:
      return make_traces(bench, known, progress);
    case Stage::Hits:
      known.hits = shared(bench.hits(progress));
      return;
    case Stage::Findings:
      known.findings = shared(bench.findings(progress));
      return;
    case Stage::RunLook:
      known.run_looks[need.node] =
          shared(look_at_run(bench.bundle(),
                             bench.recordings(progress),
                             bench.hits(progress),
                             static_cast<std::size_t>(need.node)));
      return;
    case Stage::Frfs:
      known.frfs = shared(bench.frfs(progress));
      return;
    case Stage::FrfChecks:
      known.frf_checks = shared(signal::check_frfs(bench.frfs(progress)));
      return;
    case Stage::Modes:
      known.modes = shared(bench.modes(progress));
      return;
    case Stage::Cmif:
      known.cmif = shared(indicator(bench.frfs(progress)));
      return;
    case Stage::BaseComparison:
      known.base_comparison = shared(bench.base_comparison(progress));
      return;
    case Stage::Comparison:
      known.comparison = shared(bench.comparison(progress));
      take_known_diagnoses(bench, known, progress);
      // Whose floor may be lower by what they found.
      known.comparison = shared(bench.comparison(progress));
      return;
    case Stage::Ladder:
      known.ladder = shared(bench.ladder(progress));
      known.parameters = shared(bench.model_parameters(progress));
      return;
    case Stage::Records:
      known.records = shared(bench.update_records(progress));
      return;
    case Stage::EffectEvidence:
    case Stage::CandidateEvidence:
      return make_evidence(bench, known, need, progress);
    case Stage::Diagnosis:
      known.preliminary.reset();
      known.diagnosis = shared(bench.diagnosis(progress));
      // Whose floor is lower now where less can be left.
      if (known.comparison) {
        known.comparison = shared(bench.comparison(progress));
      }
      return;
    case Stage::Robustness:
      known.diagnosis = shared(bench.robust_diagnosis(progress));
      return;
    case Stage::Signature:
      known.signatures[need.node] =
          shared(bench.signature(need.node, progress));
      return;
    case Stage::LocalisationMap:
      known.localisation_map = shared(bench.localisation_map(progress));
      return;
  }
}

}  // namespace

Job make(const Need& need) {
  return {name(need.stage),
          [need](Workbench& bench, Snapshot& known, const Progress& progress) {
            make_result(bench, known, need, progress);
            return std::string();
          },
          need};
}

std::optional<double> part_left_s(const WorkerStatus& status,
                                  std::chrono::steady_clock::time_point now) {
  constexpr double least_s = 3.0;
  constexpr double least_done = 0.05;
  const double spent_s =
      std::chrono::duration<double>(now - status.part_since).count();
  const double done = status.fraction - status.part_from;
  if (spent_s < least_s || done < least_done) return std::nullopt;
  return spent_s * (1.0 - status.fraction) / done;
}

Worker::Worker(std::unique_ptr<Workbench> bench) : bench_(std::move(bench)) {
  known_.bundle = shared(bench_->bundle());
  known_.has_model = bench_->has_model();
  known_.effects = bench_->effects();
  known_.hit_acts = bench_->hit_acts();
  finished_ = Finished{
      Finished::How::Done, "opening", taken_up(known_), std::nullopt, known_};
  thread_ = std::jthread([this](const std::stop_token& leave) { loop(leave); });
}

Worker::~Worker() { stop(); }

void Worker::start(Job job) {
  const std::lock_guard lock(mutex_);
  assert(!status_.busy && !next_ && !finished_);
  status_ = {
      true, job.title, "", 0.0, {}, std::chrono::steady_clock::now(), {}};
  stop_ = std::stop_source();
  keep_ = false;
  next_ = std::move(job);
  wake_.notify_one();
}

void Worker::stop() {
  const std::lock_guard lock(mutex_);
  stop_.request_stop();
}

void Worker::keep() { keep_ = true; }

WorkerStatus Worker::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

std::optional<Finished> Worker::take_finished() {
  const std::lock_guard lock(mutex_);
  return std::exchange(finished_, std::nullopt);
}

void Worker::report(std::string_view stage, double fraction) {
  const std::lock_guard lock(mutex_);
  const double far =
      std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.0;
  const bool other = status_.stage != stage;
  if (!status_.stage.empty() && other) note_done(status_.done, status_.stage);
  const bool anew = far < status_.fraction || (other && far == 0.0);
  if (anew || status_.stage.empty()) {
    status_.in_parts |= status_.fraction > 0.0;
    status_.part_since = std::chrono::steady_clock::now();
    status_.part_from = far;
  }
  status_.stage = stage;
  status_.fraction = far;
}

void Worker::loop(const std::stop_token& leave) {
  leave_signals_to_the_terminal();
  go_behind_the_keyboard();
  while (true) {
    Job job;
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, leave, [this] { return next_.has_value(); })) {
        return;
      }
      job = std::move(*next_);
      next_.reset();
    }
    run(job);
  }
}

std::string Worker::note_left_out() {
  const std::vector<acquisition::LeftOut> now = bench_->left_out();
  if (now.size() == known_.left_out.size()) return {};
  known_.left_out = now;
  known_.bundle = shared(bench_->bundle());  // warns of them
  const std::string first = acquisition::statement(now.front());
  return now.size() == 1
             ? first
             : fmt::format("{} runs are left out; {}", now.size(), first);
}

void Worker::run(Job& job) {
  updating::FitObserver observer;
  // The curve to be watched is the one that is worst in the beginning.
  std::optional<std::size_t> frf;
  observer.step = [this, &frf](const updating::IterationSummary& summary) {
    auto live =
        std::make_shared<updating::LiveFit>(updating::live_fit(summary, frf));
    frf = live->frf;
    const std::lock_guard lock(mutex_);
    status_.errors.push_back(live->error);
    status_.live = std::move(live);
  };
  observer.enough = [this] { return keep_.load(); };
  observer.tried = [this](const updating::Candidate& candidate) {
    const auto before = status().tried;
    auto now = shared(updating::with_tried(before.get(), candidate));
    const std::lock_guard lock(mutex_);
    status_.tried = std::move(now);
  };
  Progress progress;
  progress.report = [this](std::string_view stage, double fraction) {
    report(stage, fraction);
  };
  progress.observer =
      std::make_shared<const updating::FitObserver>(std::move(observer));
  {
    const std::lock_guard lock(mutex_);
    progress.stop = stop_.get_token();
  }
  Finished end{Finished::How::Done, job.title, "", job.need, {}};
  try {
    end.message = job.run(*bench_, known_, progress);
  } catch (const Stopped&) {
    end.how = Finished::How::Stopped;
    if (const auto tried = status().tried) known_.preliminary = tried;
  } catch (const std::exception& error) {
    end.how = Finished::How::Failed;
    end.message = error.what();
  }
  const std::string unread = note_left_out();
  if (!unread.empty()) {
    end.message = unread + (end.message.empty() ? "" : "; " + end.message);
  }
  end.snapshot = known_;
  const std::lock_guard lock(mutex_);
  finished_ = std::move(end);
  status_.busy = false;
}

}  // namespace tapfit::tui
