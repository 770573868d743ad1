#include "tui/app/session_workbench.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/output_file.hpp"
#include "tui/options/library_versions.hpp"
#include "tui/report/session_report.hpp"
#include "updating/export/measured_uff.hpp"
#include "updating/export/output_rule_of.hpp"
#include "updating/export/updated_deck.hpp"
#include "updating/localisation/signature.hpp"
#include "updating/session/added_effect.hpp"
#include "updating/session/session_file.hpp"
#include "updating/session/shared_session.hpp"
#include "updating/test_check/test_check.hpp"

#include <fmt/format.h>

namespace tapfit::tui {
namespace {

class SessionWorkbench final : public Workbench {
 public:
  SessionWorkbench(const std::filesystem::path& bundle, Work work)
      : bundle_(bundle), session_(bundle, acquisition::Unreadable::LeftOut) {
    if (work == Work::Forgotten) return;
    shared_.emplace(updating::session_file(session_.bundle()));
    if (const auto saved = shared_->news()) {
      session_.take_up(*saved);
      hit_acts_ = {saved->overruled, saved->restored};
    }
  }

  const acquisition::TestBundle& bundle() override { return session_.bundle(); }
  bool has_model() override { return session_.has_model(); }
  const structure::Deck& deck(const Progress& p) override {
    return session_.deck(p);
  }
  const std::vector<acquisition::Recording>& recordings(
      const Progress& p) override {
    return session_.recordings(p);
  }
  std::vector<acquisition::LeftOut> left_out() override {
    return session_.left_out();
  }
  const acquisition::HitSet& hits(const Progress& p) override {
    return session_.hits(p);
  }
  std::vector<Finding> findings(const Progress& p) override {
    return updating::check_test(session_, {}, p).findings;
  }
  const signal::FrfSet& frfs(const Progress& p) override {
    return session_.frfs(p);
  }
  const modal::ModeSet& modes(const Progress& p) override {
    return session_.modes(p);
  }
  const updating::Comparison& comparison(const Progress& p) override {
    return session_.comparison(p);
  }
  const updating::Comparison& base_comparison(const Progress& p) override {
    return session_.base_comparison(p);
  }
  const updating::Diagnosis& diagnosis(const Progress& p) override {
    return session_.diagnosis(p);
  }
  const updating::Diagnosis& robust_diagnosis(const Progress& p) override {
    return session_.robust_diagnosis(p);
  }
  std::optional<updating::Diagnosis> known_diagnosis(
      std::size_t effects, const Progress& p) override {
    return session_.known_diagnosis(effects, p);
  }
  updating::Signature signature(int node, const Progress& p) override {
    return session_.signature(node, p);
  }
  updating::EffectEvidence evidence(
      const updating::EffectRef& effect,
      const std::vector<updating::EffectRef>& added,
      const Progress& p) override {
    return session_.evidence(effect, added, p);
  }
  std::vector<updating::GridShare> localisation_map(
      const Progress& p) override {
    return session_.localisation_map(p);
  }
  std::vector<updating::UpdateRecord> update_records(
      const Progress& p) override {
    return session_.update_records(p);
  }
  std::vector<updating::Rung> ladder(const Progress& p) override {
    return session_.ladder(p);
  }
  std::vector<updating::Estimate> model_parameters(const Progress& p) override {
    return session_.model_parameters(p);
  }
  void overrule_hit(std::size_t run, std::size_t hit) override {
    session_.overrule_hit(run, hit);
  }
  void choose_modes(const updating::ModeChoices& choices,
                    const Progress& p) override {
    session_.choose_modes(choices, p);
  }
  updating::ModeChoices mode_choices() override {
    return session_.mode_choices();
  }
  bool undo_modes(const Progress& p) override { return session_.undo_modes(p); }
  bool redo_modes(const Progress& p) override { return session_.redo_modes(p); }
  updating::EffectRef parse_effect(const std::string& text) override {
    return updating::parse_effect(text);
  }
  void add_together(const std::vector<updating::EffectRef>& effects,
                    const Progress& p) override {
    session_.add_together(effects, p);
  }
  void toggle(std::size_t effect, const Progress& p) override {
    session_.toggle(effect, p);
  }
  bool undo(const Progress& p) override { return session_.undo(p); }
  bool redo(const Progress& p) override { return session_.redo(p); }
  std::vector<updating::AddedEffect> effects() override {
    return session_.effects();
  }
  updating::HitActs hit_acts() override { return hit_acts_; }
  std::string write(Output what,
                    const std::filesystem::path& to,
                    bool replace,
                    const Progress& p) override;
  std::optional<updating::HitActs> catch_up(const Progress& p) override;
  Saving save(const updating::HitActs& acts, const Progress& p) override;

 private:
  void write_document(updating::Session& session,
                      const std::filesystem::path& path,
                      const acquisition::OutputRule& rule,
                      const Progress& p) const;
  void write_report_to(const std::filesystem::path& path,
                       const acquisition::OutputRule& rule,
                       const Progress& p);

  std::filesystem::path bundle_;
  updating::Session session_;
  std::optional<updating::SharedSession> shared_;  ///< where work is kept
  updating::HitActs hit_acts_;                     ///< when it was opened
};

void SessionWorkbench::write_document(updating::Session& session,
                                      const std::filesystem::path& path,
                                      const acquisition::OutputRule& rule,
                                      const Progress& p) const {
  ReportData data = report_data(session, bundle_, p);
  data.versions = library_versions();
  write_report(report_document(data), path, rule);
}

// Where nothing was added, the report adds what the diagnosis supports: in a
// session of its own, so that the user's stays as it is.
void SessionWorkbench::write_report_to(const std::filesystem::path& path,
                                       const acquisition::OutputRule& rule,
                                       const Progress& p) {
  if (!session_.has_model() || !session_.effects().empty()) {
    return write_document(session_, path, rule, p);
  }
  updating::Session worked = session_.beside();
  write_document(worked, path, rule, p);
}

// The deck, what was written beside it, and how much of it is to be known.
std::string told_of(const updating::WrittenDeck& deck) {
  std::string text = deck.files.front().string();
  for (std::size_t k = 1; k < deck.files.size(); ++k) {
    text += ", " + deck.files[k]
                       .lexically_relative(deck.files.front().parent_path())
                       .string();
  }
  const std::size_t notes = deck.notes.size();
  if (notes > 0) {
    text +=
        fmt::format("; {} stand{} in it as {}",
                    notes == 1 ? "a note" : std::to_string(notes) + " notes",
                    notes == 1 ? "s" : "",
                    notes == 1 ? "a comment" : "comments");
  }
  return text;
}

std::string SessionWorkbench::write(Output what,
                                    const std::filesystem::path& to,
                                    bool replace,
                                    const Progress& p) {
  const acquisition::OutputRule rule =
      updating::output_rule_of(session_.bundle(), replace, {to});
  rule.check(to);
  if (what == Output::Deck) {
    updating::check_has_deck(session_);
    return told_of(updating::write_updated_deck(session_, to, rule, p));
  }
  if (what == Output::Report) {
    write_report_to(to, rule, p);
  } else {
    updating::write_measured_uff(
        session_, to, rule, acquisition::UffNodes::D2411, p);
  }
  return to.string();
}

std::optional<updating::HitActs> SessionWorkbench::catch_up(const Progress& p) {
  if (!shared_) return std::nullopt;
  p("session of another window", 0.0);
  const auto saved = shared_->news();
  if (!saved) return std::nullopt;
  session_ = updating::Session(bundle_, acquisition::Unreadable::LeftOut);
  session_.take_up(*saved);
  return updating::HitActs{saved->overruled, saved->restored};
}

Saving SessionWorkbench::save(const updating::HitActs& acts,
                              const Progress& p) {
  if (!shared_) return {};
  try {
    updating::SavedSession saved = session_.saved(p);
    saved.overruled = acts.done;
    saved.restored = acts.undone;
    return {!shared_->write(saved), {}};
  } catch (const InputError& error) {
    return {false, error.what()};
  }
}

}  // namespace

std::unique_ptr<Workbench> open_session(const std::filesystem::path& bundle,
                                        Work work) {
  return std::make_unique<SessionWorkbench>(bundle, work);
}

}  // namespace tapfit::tui
