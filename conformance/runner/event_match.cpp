#include "conformance/runner/event_match.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "conformance/runner/entry.hpp"
#include "conformance/runner/text.hpp"

namespace kerf::conformance {
namespace {

bool is_count(std::string_view key) {
  return key == "line" || key == "column" || key == "n" || key == "program";
}

bool field_fits(const Field& expected, const Field* observed, double tolerance) {
  if (observed == nullptr || observed->value.index() != expected.value.index()) return false;
  if (const auto* text = std::get_if<std::string>(&expected.value)) {
    return *text == std::get<std::string>(observed->value);
  }
  const double allowed = is_count(expected.key) ? 0.0 : expected.tolerance.value_or(tolerance);
  return std::abs(std::get<double>(expected.value) - std::get<double>(observed->value)) <= allowed;
}

bool words_fit(const Entry& expected, const Entry& observed) {
  if (expected.name != observed.name) return false;
  const bool any = expected.words.empty() && (expected.name == "alarm" || expected.name == "warning");
  return any || expected.words == observed.words;
}

/// `X=9 Z=1` of the fields that do not fit.
std::string differing_fields(const Entry& expected, const Entry& observed, double tolerance) {
  std::string text;
  for (const Field& field : expected.fields) {
    const Field* seen = observed.find(field.key);
    if (field_fits(field, seen, tolerance)) continue;
    std::string value = "absent";
    if (seen != nullptr) {
      const double* number = std::get_if<double>(&seen->value);
      value = number != nullptr ? number_text(*number) : std::get<std::string>(seen->value);
    }
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", field.key, value);
  }
  return text;
}

/// The cheapest way to turn one list into the other: 1 for a missing or surplus event and for a pair of the
/// same event with other values.
class Alignment {
 public:
  Alignment(const std::vector<Entry>& expected, const std::vector<Entry>& observed, double tolerance)
      : expected_(expected), observed_(observed), tolerance_(tolerance) {
    const std::size_t rows = expected.size() + 1;
    columns_ = observed.size() + 1;
    costs_.assign(rows * columns_, 0);
    for (std::size_t i = rows; i-- > 0;) {
      for (std::size_t j = columns_; j-- > 0;) cost(i, j) = cheapest(i, j);
    }
  }

  std::string text() const {
    std::string text;
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < expected_.size() || j < observed_.size()) {
      const bool both = i < expected_.size() && j < observed_.size();
      if (both && cost(i, j) == pair_cost(i, j) + cost(i + 1, j + 1)) {
        text += pair_text(expected_[i++], observed_[j++]);
      } else if (i < expected_.size() && cost(i, j) == 1 + cost(i + 1, j)) {
        text += fmt::format("- {}\n", entry_text(expected_[i++]));
      } else {
        text += fmt::format("+ {}\n", entry_text(observed_[j++]));
      }
    }
    return text;
  }

 private:
  static constexpr int kNoPair = 1'000'000'000;

  int& cost(std::size_t i, std::size_t j) { return costs_[i * columns_ + j]; }
  int cost(std::size_t i, std::size_t j) const { return costs_[i * columns_ + j]; }

  int pair_cost(std::size_t i, std::size_t j) const {
    if (fits(expected_[i], observed_[j], tolerance_)) return 0;
    return words_fit(expected_[i], observed_[j]) ? 1 : kNoPair;
  }

  int cheapest(std::size_t i, std::size_t j) const {
    if (i == expected_.size()) return static_cast<int>(observed_.size() - j);
    if (j == observed_.size()) return static_cast<int>(expected_.size() - i);
    const int pair = pair_cost(i, j);
    const int apart = 1 + std::min(cost(i + 1, j), cost(i, j + 1));
    return pair == kNoPair ? apart : std::min(apart, pair + cost(i + 1, j + 1));
  }

  std::string pair_text(const Entry& expected, const Entry& observed) const {
    const std::string differing = differing_fields(expected, observed, tolerance_);
    if (differing.empty()) return fmt::format("  {}\n", entry_text(expected));
    return fmt::format("- {}\n+ {}   (not as expected: {})\n", entry_text(expected), entry_text(observed),
                       differing);
  }

  const std::vector<Entry>& expected_;
  const std::vector<Entry>& observed_;
  double tolerance_;
  std::size_t columns_ = 0;
  std::vector<int> costs_;
};

}  // namespace

std::vector<Entry> watched_events(const std::vector<Entry>& events, const std::set<std::string>& kinds) {
  std::vector<Entry> watched;
  for (const Entry& event : events) {
    if (event.name == "refused" || kinds.count(watch_kind(event.name)) != 0) watched.push_back(event);
  }
  return watched;
}

bool fits(const Entry& expected, const Entry& observed, double tolerance) {
  if (!words_fit(expected, observed)) return false;
  return std::all_of(expected.fields.begin(), expected.fields.end(), [&](const Field& field) {
    return field_fits(field, observed.find(field.key), tolerance);
  });
}

std::string event_difference(const std::vector<Entry>& expected, const std::vector<Entry>& observed,
                             double tolerance) {
  const auto fit = [=](const Entry& a, const Entry& b) { return fits(a, b, tolerance); };
  if (std::equal(expected.begin(), expected.end(), observed.begin(), observed.end(), fit)) return {};
  constexpr std::size_t kMostCells = 4'000'000;  // longer lists are cut for the picture
  if ((expected.size() + 1) * (observed.size() + 1) <= kMostCells) {
    return Alignment(expected, observed, tolerance).text();
  }
  const auto [first, second] =
      std::mismatch(expected.begin(), expected.end(), observed.begin(), observed.end(), fit);
  return fmt::format("event {}:\n- {}\n+ {}\n({} events expected, {} observed)\n",
                     first - expected.begin() + 1, first == expected.end() ? "nothing" : entry_text(*first),
                     second == observed.end() ? "nothing" : entry_text(*second), expected.size(),
                     observed.size());
}

std::vector<Entry> without_place(const std::vector<Entry>& events) {
  std::vector<Entry> result = events;
  for (Entry& event : result) {
    const auto tells_place = [](const Field& field) {
      return is_count(field.key) || (field.key.size() == 2 && field.key[0] == 'm');
    };
    event.fields.erase(std::remove_if(event.fields.begin(), event.fields.end(), tells_place),
                       event.fields.end());
  }
  return result;
}

}  // namespace kerf::conformance
