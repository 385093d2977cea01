// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the words of a supplement back into the parts of a document.
#pragma once

#include <fmt/format.h>

#include <charconv>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/model/document_fields.hpp"

namespace tetproof::io {

/// Every failure is an InputError that begins with `place`.
class Decoder {
 public:
  Decoder(std::string_view text, std::string place) : text_(text), place_(std::move(place)) {}

  template <class... T>
  void operator()(T&... values) {
    (get(values), ...);
  }

  std::string_view word() {
    while (at_ < text_.size() && text_[at_] <= ' ') ++at_;
    const std::size_t start = at_;
    while (at_ < text_.size() && text_[at_] > ' ') ++at_;
    return text_.substr(start, at_ - start);
  }
  std::string_view peek() {
    const std::size_t here = at_;
    const std::string_view next = word();
    at_ = here;
    return next;
  }

  /// Reads how many things follow, each of at least two bytes.
  std::size_t count() {
    std::size_t value = 0;
    get(value);
    if (value > (text_.size() - at_ + 1) / 2)
      fail(fmt::format("{} announced, more than the {} left can hold", counted(value, "things"),
                       counted(text_.size() - at_, "bytes")));
    return value;
  }

  [[noreturn]] void fail(std::string_view message) const {
    throw InputError(fmt::format("{}, byte {} of the supplement: {}", place_, at_, message));
  }

 private:
  template <std::integral T>
  void get(T& value) {
    std::int64_t wide = 0;
    number(wide, "an integer");
    if (!std::in_range<std::conditional_t<std::same_as<T, bool>, std::uint8_t, T>>(wide) ||
        (std::same_as<T, bool> && wide > 1))
      fail(fmt::format("{} is out of range", wide));
    value = static_cast<T>(wide);
  }
  void get(double& value) { number(value, "a number"); }
  void number(auto& value, const char* expected) {
    const std::string_view next = word();
    const auto [end, error] = std::from_chars(next.data(), next.data() + next.size(), value);
    if (error != std::errc() || end != next.data() + next.size() || next.empty())
      fail(fmt::format("expected {}, found '{}'", expected, next.substr(0, 40)));
  }
  void get(std::string& text) {
    text.clear();
    for (std::size_t pieces = count(); pieces > 0; --pieces) {
      const std::string_view piece = word();
      if (!piece.starts_with('"')) fail("expected a text");
      for (std::size_t i = 1; i < piece.size(); ++i) {
        unsigned byte = static_cast<unsigned char>(piece[i]);
        if (piece[i] == '\\') {
          const std::string_view digits = piece.substr(i + 1, 2);
          const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
          if (error != std::errc() || digits.size() != 2 || end != digits.data() + 2)
            fail("expected two hexadecimal digits behind a backslash");
          i += 2;
        }
        text += static_cast<char>(byte);
      }
    }
  }
  void get(Eigen::Vector3d& p) { (*this)(p[0], p[1], p[2]); }
  template <class T, std::size_t N>
  void get(std::array<T, N>& values) {
    for (T& value : values) get(value);
  }
  template <class T>
  void get(std::vector<T>& values) {
    values.clear();
    for (std::size_t left = count(); left > 0; --left) get(values.emplace_back());
  }
  template <class T>
  requires std::is_class_v<T>
  void get(T& part) { fields(part, *this); }

  std::string_view text_;
  const std::string place_;
  std::size_t at_ = 0;
};

}  // namespace tetproof::io
