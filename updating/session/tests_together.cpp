#include "updating/session/tests_together.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/fit/fit_problem.hpp"
#include "updating/fit/overall_progress.hpp"
#include "updating/session/fitted_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// A parameter of one test that others may have, too.
struct Named {
  std::string name;
  Index at = 0;          // in its theta
  double nominal = 1.0;  // theta is ln(value / nominal)
  std::string unit = {};
};

// How a test's parameters are called among all tests.
std::vector<Named> shareable(const FittedTest& test,
                             const TogetherChoice& choice) {
  std::vector<Named> result;
  const FitProblem& problem = test.fitter.problem();
  const std::size_t properties =
      problem.uncertain_sd.size() - problem.corrections.size();
  for (std::size_t k = 0; k < properties && !choice.structures; ++k) {
    const PropertyName& p = test.properties[k];
    if (std::ranges::find(choice.own, p.name) != choice.own.end()) continue;
    result.push_back({p.name, static_cast<Index>(k), p.nominal, p.unit});
  }
  // A deck that is wrong in form is so in all of its tests.
  for (std::size_t k = 0; k < problem.corrections.size() && !choice.structures;
       ++k) {
    result.push_back({"form " + problem.corrections[k].name,
                      static_cast<Index>(properties + k)});
  }
  const ModelState& state = test.fit.result.state;
  Index at = std::ssize(state.factor) + state.zeta.size();
  for (std::size_t e = 0; e < choice.shared.size(); ++e) {
    for (std::size_t k = 0; k < state.effects[e].p.size(); ++k) {
      result.push_back({fmt::format("effect {} size {}", e, k), at++});
    }
  }
  return result;
}

// What two tests or more have, in the order in which it is met.
std::vector<std::string> shared_names(
    const std::vector<std::vector<Named>>& all) {
  std::map<std::string, int> tests;
  std::vector<std::string> order;
  for (const std::vector<Named>& own : all) {
    for (const Named& one : own) {
      if (tests[one.name]++ == 0) order.push_back(one.name);
    }
  }
  std::erase_if(order, [&](const auto& name) { return tests[name] < 2; });
  return order;
}

const Named* find(const std::vector<Named>& all, const std::string& name) {
  const auto it = std::ranges::find(all, name, &Named::name);
  return it == all.end() ? nullptr : &*it;
}

// Who has it first: its nominal value is the measure.
const Named& first_of(const std::vector<std::vector<Named>>& all,
                      const std::string& name) {
  for (const std::vector<Named>& own : all) {
    if (const Named* one = find(own, name)) return *one;
  }
  throw std::logic_error("nobody has " + name);
}

std::vector<JointTest> joint_tests(const std::vector<FittedTest>& tests,
                                   const std::vector<std::vector<Named>>& named,
                                   const std::vector<std::string>& shared,
                                   const TogetherChoice& choice,
                                   const std::vector<std::string>& names) {
  std::vector<JointTest> result;
  for (std::size_t t = 0; t < tests.size(); ++t) {
    const int structure = choice.structures ? static_cast<int>(t) : 0;
    JointTest joint{&tests[t].fitter, tests[t].fit, {}, {}, structure};
    const Index count = pack(tests[t].fit.result.state).size();
    joint.shared.resize(static_cast<std::size_t>(count));
    joint.offset.setZero(count);
    for (std::size_t s = 0; s < shared.size(); ++s) {
      const Named* own = find(named[t], shared[s]);
      if (own == nullptr) continue;
      const Named& first = first_of(named, shared[s]);
      if (own->unit != first.unit) {
        throw InputError(
            fmt::format("{} is in {} in one test and in {} in another",
                        own->name,
                        first.unit,
                        own->unit),
            names[t],
            "name it with --own, or give the decks one system of units");
      }
      joint.shared[static_cast<std::size_t>(own->at)] = s;
      joint.offset(own->at) = std::log(first.nominal / own->nominal);
    }
    result.push_back(std::move(joint));
  }
  return result;
}

void add_effects(Session& session,
                 std::size_t own,
                 const TogetherChoice& choice,
                 const Progress& progress) {
  std::vector<EffectRef> effects = choice.shared;
  effects.insert(effects.end(), choice.each.begin(), choice.each.end());
  for (const auto& [test, effect] : choice.single) {
    if (test == own) effects.push_back(effect);
  }
  session.fit_uncertain(progress);
  session.add_together(effects, progress);
}

// Of a test: its properties, then its effects, each with the name by which
// tests share it, or none.
struct Told {
  Estimate estimate;
  std::string shared = {};
};

std::vector<Told> told(const FittedTest& test,
                       const Fit& fit,
                       const TogetherChoice& choice,
                       const std::vector<std::string>& shared) {
  std::vector<Told> result;
  const auto is_shared = [&shared](const std::string& name) {
    return std::ranges::find(shared, name) != shared.end();
  };
  for (Estimate& e : property_estimates(fit, test.properties)) {
    const std::string name = is_shared(e.name) ? e.name : "";
    result.push_back({std::move(e), name});
  }
  for (std::size_t k = 0; k < fit.effects.size(); ++k) {
    for (Estimate& e : effect_estimates(fit, k, test.context)) {
      e.name = label_of(fit.effects, k) + " " + e.name;
      const std::string name = k < choice.shared.size() ? e.name : "";
      result.push_back({std::move(e), name});
    }
  }
  return result;
}

Agreement agreement_of(const std::vector<std::optional<Estimate>>& alone) {
  std::vector<double> value;
  std::vector<double> variance;
  for (const auto& e : alone) {
    if (!e || e->sd <= 0.0 || e->value == 0.0) continue;
    value.push_back(std::log(std::abs(e->value)));
    variance.push_back(std::pow(e->sd / e->value, 2));
  }
  if (value.size() < 2) return {};
  const auto n = static_cast<Index>(value.size());
  return agreement(VectorXd::Map(value.data(), n),
                   VectorXd::Map(variance.data(), n));
}

std::vector<std::vector<PropertyName>> properties_of(
    std::vector<Session>& sessions, const Progress& progress) {
  std::vector<std::vector<PropertyName>> result;
  for (Session& session : sessions) {
    result.push_back(property_names(session.bundle(), session.deck(progress)));
  }
  return result;
}

// Before the work of fitting them.
void check_shared(const std::vector<std::vector<PropertyName>>& properties,
                  const std::vector<std::string>& names,
                  const TogetherChoice& choice) {
  std::map<std::string, int> tests;
  for (const std::vector<PropertyName>& own : properties) {
    for (const PropertyName& p : own) ++tests[p.name];
  }
  for (const std::string& own : choice.own) {
    if (tests.erase(own) > 0) continue;
    throw InputError("no test has an uncertain property " + own,
                     "--own " + own,
                     "name one as results do, for example E:1");
  }
  const bool any = std::ranges::any_of(
      tests, [](const auto& property) { return property.second > 1; });
  if (!choice.shared.empty() || (any && !choice.structures)) return;
  throw InputError("the tests share nothing",
                   names.front(),
                   "list the same property as `uncertain` in every test.json, "
                   "or name an effect with --shared-effect");
}

void check_different(const std::vector<Session>& sessions,
                     const std::vector<std::string>& names) {
  std::set<std::filesystem::path> known;
  for (std::size_t t = 0; t < sessions.size(); ++t) {
    if (known
            .insert(
                std::filesystem::weakly_canonical(sessions[t].bundle().file))
            .second) {
      continue;
    }
    throw InputError("the test is there twice",
                     names[t],
                     "it would count as two: name each test once");
  }
}

// One size for all: an effect has as many in each test.
void check_sizes(const std::vector<FittedTest>& tests,
                 const std::vector<std::string>& names,
                 const TogetherChoice& choice) {
  for (std::size_t e = 0; e < choice.shared.size(); ++e) {
    const std::size_t first = tests.front().fit.effects[e].p.size();
    for (std::size_t t = 1; t < tests.size(); ++t) {
      const EffectInstance& own = tests[t].fit.effects[e];
      if (own.p.size() == first) continue;
      throw InputError(
          fmt::format("{} has {} sizes here and {} in {}",
                      effect_text(own.effect->name(), own.where),
                      own.p.size(),
                      first,
                      names.front()),
          names[t],
          "name the place so that it is the same in all tests, or let each "
          "have its own with --effect");
    }
  }
}

}  // namespace

bool TestTogether::agrees() const {
  return error <= std::hypot(alone_error, floor);
}

bool TestsTogether::agree() const {
  return std::ranges::all_of(tests, &TestTogether::agrees);
}

TestsTogether fit_tests_together(std::vector<Session>& sessions,
                                 const std::vector<std::string>& names,
                                 const TogetherChoice& choice,
                                 const Progress& progress) {
  check_different(sessions, names);
  check_shared(properties_of(sessions, progress), names, choice);
  const auto count = static_cast<double>(sessions.size() + 1);
  std::vector<FittedTest> tests;
  std::vector<std::vector<Named>> named;
  for (std::size_t t = 0; t < sessions.size(); ++t) {
    const auto begin = static_cast<double>(t);
    const Progress part =
        part_of(progress, begin / count, (begin + 1.0) / count);
    add_effects(sessions[t], t, choice, part);
    tests.push_back(sessions[t].fitted(part));
    named.push_back(shareable(tests.back(), choice));
  }
  check_sizes(tests, names, choice);
  const std::vector<std::string> shared = shared_names(named);
  JointFit joint =
      fit_together(joint_tests(tests, named, shared, choice, names),
                   part_of(progress, 1.0 - 1.0 / count, 1.0));

  TestsTogether result;
  result.converged = joint.converged;
  result.message = joint.message;
  std::map<std::string, std::size_t> known;  // position in result.shared
  for (std::size_t t = 0; t < tests.size(); ++t) {
    const auto alone = told(tests[t], tests[t].fit, choice, shared);
    const auto together = told(tests[t], joint.fits[t], choice, shared);
    TestTogether own{tests[t].deck.result.error,
                     tests[t].fit.result.error,
                     joint.fits[t].result.error,
                     sessions[t].comparison(progress).floor,
                     {}};
    for (std::size_t k = 0; k < together.size(); ++k) {
      if (together[k].shared.empty()) {
        own.own.push_back(together[k].estimate);
        continue;
      }
      const auto [at, fresh] =
          known.try_emplace(together[k].shared, result.shared.size());
      if (fresh) {
        result.shared.push_back({together[k].estimate, {}, {}});
        result.shared.back().alone.resize(tests.size());
      }
      result.shared[at->second].alone[t] = alone[k].estimate;
    }
    result.tests.push_back(std::move(own));
  }
  for (SharedEstimate& s : result.shared) s.agreement = agreement_of(s.alone);
  return result;
}

}  // namespace tapfit::updating
