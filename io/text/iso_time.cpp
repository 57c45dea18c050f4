// SPDX-License-Identifier: Apache-2.0
#include "io/text/iso_time.hpp"

#include <charconv>
#include <chrono>

namespace torquewright::io {
namespace {

constexpr double kMinute_s = 60.0, kHour_s = 3600.0, kDay_s = 86400.0;

/// Takes words off the front of a text; what does not fit makes all that follows fail.
class Front {
 public:
  explicit Front(std::string_view text) : text_(text) {}

  int digits(std::size_t count) {
    int value = 0;
    fits_ = fits_ && text_.size() >= count &&
            text_.substr(0, count).find_first_not_of("0123456789") == std::string_view::npos;
    if (!fits_) return 0;
    std::from_chars(text_.data(), text_.data() + count, value);
    text_.remove_prefix(count);
    return value;
  }

  char one_of(std::string_view characters) {
    fits_ = fits_ && !text_.empty() && characters.find(text_.front()) != std::string_view::npos;
    if (!fits_) return 0;
    const char first = text_.front();
    text_.remove_prefix(1);
    return first;
  }

  /// ".25", or nothing.
  double fraction() {
    if (!fits_ || text_.empty() || (text_.front() != '.' && text_.front() != ',')) return 0.0;
    text_.remove_prefix(1);
    double value = 0.0, unit = 0.1;
    fits_ = !text_.empty() && text_.front() >= '0' && text_.front() <= '9';
    for (; !text_.empty() && text_.front() >= '0' && text_.front() <= '9'; unit *= 0.1) {
      value += unit * (text_.front() - '0');
      text_.remove_prefix(1);
    }
    return value;
  }

  bool begins_with(char first) const { return fits_ && text_.starts_with(first); }
  bool is_done() const { return text_.empty(); }
  bool fits() const { return fits_; }

 private:
  std::string_view text_;
  bool fits_ = true;
};

/// Of Z, +01:00, -0530 or nothing, in s.
double offset_s(Front& front) {
  if (front.is_done()) return 0.0;
  const char sign = front.one_of("Z+-");
  if (sign == 'Z' || sign == 0) return 0.0;
  const int hours = front.digits(2);
  int minutes = 0;
  if (!front.is_done()) {
    Front without_colon = front;
    minutes = without_colon.digits(2);
    if (without_colon.fits()) {
      front = without_colon;
    } else {
      front.one_of(":");
      minutes = front.digits(2);
    }
  }
  return (sign == '-' ? -1.0 : 1.0) * (hours * kHour_s + minutes * kMinute_s);
}

}  // namespace

std::optional<double> seconds_of_iso_time(std::string_view text) {
  Front front(text);
  const int year = front.digits(4);
  front.one_of("-/");
  const int month = front.digits(2);
  front.one_of("-/");
  const int day = front.digits(2);
  front.one_of("T ");
  const int hour = front.digits(2);
  front.one_of(":");
  const int minute = front.digits(2);
  int second = 0;
  double fraction_s = 0.0;
  if (front.begins_with(':')) {
    front.one_of(":");
    second = front.digits(2);
    fraction_s = front.fraction();
  }
  const double offset = offset_s(front);
  if (!front.fits() || !front.is_done()) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok() || hour > 23 || minute > 59 || second > 60) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return static_cast<double>(days) * kDay_s + hour * kHour_s + minute * kMinute_s + second -
         offset + fraction_s;
}

}  // namespace torquewright::io
