#include "tui/together/together_output.hpp"

#include "tui/report/effect_output.hpp"
#include "tui/report/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {

using nlohmann::ordered_json;
using updating::Estimate;
using updating::SharedEstimate;
using updating::TestsTogether;

namespace {

ordered_json shared_json(const SharedEstimate& shared) {
  ordered_json alone = ordered_json::array();
  for (const auto& e : shared.alone) {
    alone.push_back(e ? estimate_json(*e) : ordered_json());
  }
  ordered_json json = {{"parameter", shared.together.name}};
  json.update(estimate_json(shared.together));
  json["alone"] = std::move(alone);
  json["agreement"] = {{"q", shared.agreement.q},
                       {"degrees", shared.agreement.degrees},
                       {"probability", shared.agreement.probability}};
  return json;
}

std::string sized(const Estimate& e) {
  return size_words(e) + (e.at_bound ? " (at its bound)" : "");
}

std::string tests_text(const TestsTogether& found,
                       const std::vector<std::string>& names) {
  TextTable table({"", "<test", "deck", "alone", "together", "floor"});
  for (std::size_t t = 0; t < found.tests.size(); ++t) {
    const updating::TestTogether& test = found.tests[t];
    table.add({fmt::format("{}", t + 1),
               names[t],
               percent(test.deck_error),
               percent(test.alone_error),
               percent(test.error),
               percent(test.floor)});
  }
  return table.text();
}

// Whether one number does for all.
std::string verdict_text(const TestsTogether& found) {
  if (found.agree()) {
    return "They agree: with what they share each leaves what it leaves alone, "
           "within its floor.\n";
  }
  std::string text = "They do NOT agree in what they are to share:\n";
  for (std::size_t t = 0; t < found.tests.size(); ++t) {
    const updating::TestTogether& test = found.tests[t];
    if (test.agrees()) continue;
    text += fmt::format("  test {} leaves {} with it and {} alone\n",
                        t + 1,
                        percent(test.error),
                        percent(test.alone_error));
  }
  return text +
         "  something else differs between them: diagnose each by itself, or "
         "let what\n  differs be each test's own (--own, --effect)\n";
}

std::string shared_text(const SharedEstimate& shared) {
  const updating::Agreement& a = shared.agreement;
  std::string text = fmt::format("  {}  {}\n",
                                 parameter_words(shared.together.name),
                                 sized(shared.together));
  for (std::size_t t = 0; t < shared.alone.size(); ++t) {
    const auto& alone = shared.alone[t];
    if (!alone) continue;
    text += fmt::format("      test {} alone  {}\n", t + 1, sized(*alone));
  }
  if (a.degrees == 0) return text;
  return text + fmt::format(
                    "      as different by chance in {} of cases (Q "
                    "{:.1f} for {})\n",
                    probability(a.probability),
                    a.q,
                    a.degrees);
}

}  // namespace

ordered_json together_json(const TestsTogether& found,
                           const std::vector<std::string>& names) {
  ordered_json tests = ordered_json::array();
  for (std::size_t t = 0; t < found.tests.size(); ++t) {
    const updating::TestTogether& test = found.tests[t];
    tests.push_back({{"bundle", names[t]},
                     {"error",
                      {{"base", test.deck_error},
                       {"alone", test.alone_error},
                       {"together", test.error},
                       {"floor", test.floor}}},
                     {"agrees", test.agrees()},
                     {"parameters", parameters_json(test.own)}});
  }
  ordered_json shared = ordered_json::array();
  for (const SharedEstimate& s : found.shared) shared.push_back(shared_json(s));
  return {{"tests", std::move(tests)},
          {"shared", std::move(shared)},
          {"agree", found.agree()},
          {"converged", found.converged},
          {"message", found.message}};
}

std::string together_text(const TestsTogether& found,
                          const std::vector<std::string>& names) {
  std::string text = fmt::format(
      "{} tests fitted together ({})\n\n", found.tests.size(), found.message);
  text += tests_text(found, names) + verdict_text(found) + "\nShared\n";
  for (const SharedEstimate& s : found.shared) text += shared_text(s);
  for (std::size_t t = 0; t < found.tests.size(); ++t) {
    if (found.tests[t].own.empty()) continue;
    text += fmt::format("\nTest {} by itself\n", t + 1);
    for (const Estimate& e : found.tests[t].own) {
      text += fmt::format("  {}  {}\n", parameter_words(e.name), sized(e));
    }
  }
  return text;
}

}  // namespace tapfit::tui
