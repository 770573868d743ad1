#include "tui/session_workbench.hpp"

#include "acquisition/input_error.hpp"
#include "tui/session_file.hpp"
#include "updating/saved_session.hpp"

#include <system_error>

namespace tapfit::tui {
namespace {

class SessionWorkbench final : public Workbench {
 public:
  explicit SessionWorkbench(const std::filesystem::path& bundle)
      : session_(bundle), file_(session_file(bundle)) {
    std::error_code ignored;
    if (std::filesystem::exists(file_, ignored)) {
      session_.take_up(updating::read_saved_session(file_));
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
  const acquisition::HitSet& hits(const Progress& p) override {
    return session_.hits(p);
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
  updating::Signature signature(int node, const Progress& p) override {
    return session_.signature(node, p);
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
  void add(const updating::EffectRef& effect, const Progress& p) override {
    session_.add(effect, p);
  }
  void toggle(std::size_t effect, const Progress& p) override {
    session_.toggle(effect, p);
  }
  bool undo(const Progress& p) override { return session_.undo(p); }
  bool redo(const Progress& p) override { return session_.redo(p); }
  std::vector<updating::AddedEffect> effects() override {
    return session_.effects();
  }
  std::vector<updating::OverruledHit> overruled() override {
    return session_.overruled();
  }
  std::string save(const Progress& p) override;

 private:
  updating::Session session_;
  std::filesystem::path file_;
};

std::string SessionWorkbench::save(const Progress& p) {
  try {
    const updating::SavedSession saved = session_.saved(p);
    std::error_code ignored;
    if (!saved.empty()) {
      write_saved_session(file_, saved);
    } else {
      std::filesystem::remove(file_, ignored);
    }
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

std::unique_ptr<Workbench> open_session(const std::filesystem::path& bundle) {
  return std::make_unique<SessionWorkbench>(bundle);
}

}  // namespace tapfit::tui
