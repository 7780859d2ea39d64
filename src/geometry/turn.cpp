#include "geometry/turn.hpp"

#include <cmath>

namespace kerf {

Turn turn_by(double degrees) {
  // What is left beside whole quarter turns, -45 to 45 degrees.
  int quarters = 0;
  const double rest = std::remquo(degrees, 90.0, &quarters);
  const double sine = std::sin(radians(rest));
  const double cosine = std::cos(radians(rest));
  switch (static_cast<unsigned>(quarters) % 4U) {
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    case 3:
      return {-cosine, sine};
    default:
      return {sine, cosine};
  }
}

}  // namespace kerf
