// SPDX-License-Identifier: MIT
// Composes a gnuplot script from the values that a template uses, the common style, and the
// template.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plot_script.hpp"

namespace polhode {

/// Builds a gnuplot script. Texts are quoted so that nothing in them is evaluated. Templates
/// contain no text from users.
class FigureScript {
 public:
  /// @param width, height  size in pixels; bitmaps have twice as many
  FigureScript(const Image& image, int width, int height);

  /// Defines a number with a decimal point, because gnuplot truncates the quotient of two integers.
  FigureScript& number(std::string_view name, double value);
  FigureScript& count(std::string_view name, std::size_t value);
  FigureScript& text(std::string_view name, std::string_view value);
  /// Defines the name of a file in the folder of the script.
  FigureScript& file(std::string_view name, std::string_view path);
  /// Defines gnuplot arrays, which are indexed from 1. An empty array is written with one element:
  /// 0 or an empty text.
  FigureScript& counts(std::string_view name, std::span<const std::size_t> values);
  FigureScript& numbers(std::string_view name, std::span<const double> values);
  FigureScript& texts(std::string_view name, std::span<const std::string> values);
  /// Defines the number of schemes and their names, colours, markers, and first and last rows:
  /// `curves`, `name`, `colour`, `filled`, `open`, `first`, `last`.
  FigureScript& schemes(const std::vector<SchemeRows>& schemes);

  /// The gnuplot script, including the common style and the template data/plots/NAME.gp.
  std::string with(std::string_view name) const;

 private:
  /// Defines an array.
  /// @param none  element of an empty array, because gnuplot evaluates an element even in a loop
  ///   without iterations
  FigureScript& array(std::string_view name, auto values, std::string_view none,
                      const auto& text_of);

  std::string text_;
};

}  // namespace polhode
