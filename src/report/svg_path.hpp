#pragma once
// The data of an SVG path of many strokes, as short as the resolution of the picture allows.

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>

#include "report/move_geometry.hpp"

namespace kerf {

/// An elliptical arc on the picture, of at most half a turn.
struct ArcStroke {
  double radius_x = 0.0;
  double radius_y = 0.0;
  bool clockwise = false;  ///< on the picture
};

/// Joins strokes that follow each other and leaves out points that lie within `tolerance` of the line without
/// them (sleeve simplification), and strokes that were drawn before. Picture units, y downwards.
class SvgPath {
 public:
  explicit SvgPath(double tolerance) : tolerance_(tolerance) {}

  void line(Point2 from, Point2 to);
  void arc(Point2 from, Point2 to, const ArcStroke& stroke);

  /// The value for the attribute `d`. Nothing may be added afterwards.
  const std::string& finish();

 private:
  /// Hundredths of a picture unit: what is written, so that rounding does not add up.
  struct Place {
    std::int64_t x = 0;
    std::int64_t y = 0;
    friend bool operator==(const Place&, const Place&) = default;
  };

  static Place place_of(Point2 point);
  void begin_at(Place from);
  bool extends_sleeve(Place to);
  void flush();
  void emit_line(Place to);
  void move_pen(Place to);
  bool is_new(Place from, Place to, std::uint64_t kind);
  void append_command(char command);
  void append_value(std::int64_t hundredths);

  double tolerance_;
  std::string data_;
  std::unordered_set<std::uint64_t> seen_;
  bool pen_down_ = false;  ///< pen_ is where the data stands
  Place pen_;
  Place anchor_;            ///< start of the stroke that is being extended
  Place pending_;           ///< its end so far
  bool active_ = false;     ///< anchor_ and pending_ hold something
  double reach_ = 0.0;      ///< largest distance from the anchor so far
  double direction_ = 0.0;  ///< of the sleeve
  double low_ = 0.0;        ///< allowed directions, relative to direction_
  double high_ = 0.0;
  bool has_sleeve_ = false;
  char last_command_ = ' ';
  bool needs_space_ = false;
};

/// Appends a path element of a class of the style sheet; nothing without data.
void append_path(std::string& out, std::string_view style, std::string_view data);

}  // namespace kerf
