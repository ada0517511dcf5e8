// SPDX-License-Identifier: MIT
// The sun of a scene by time and place.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/scratch_project.h"
#include "scene/sun_at_time.h"

namespace gnomon::scene {
namespace {

using TimedSun = ScratchProject;

/// A scene whose sun is this.
std::string sun_text(const std::string& members) {
  return "\"sun\": {" + members + "}";
}

constexpr const char* kNrel =
    R"("time": "2003-10-17T19:30:30Z", "latitude": 39.742476, "longitude": -105.1786)";

TEST_F(TimedSun, BecomesAngles) {
  const Scene geometric = load(scene(sun_text(kNrel))).tests.at(0);
  EXPECT_NEAR(geometric.sun.azimuth, 194.340241, 0.0003);
  EXPECT_NEAR(geometric.sun.elevation, 39.872046, 0.0003);
  const Scene lifted = load(scene(sun_text(std::string(kNrel) + R"(, "refraction": true)"))).tests.at(0);
  EXPECT_EQ(lifted.sun.azimuth, geometric.sun.azimuth);
  EXPECT_DOUBLE_EQ(lifted.sun.elevation,
                   geometric.sun.elevation + ephemeris::refraction(geometric.sun.elevation));
}

TEST_F(TimedSun, SaysWhatItBecomesAndAnglesSayNothing) {
  const Scene test = load(scene(sun_text(kNrel))).tests.at(0);
  ASSERT_EQ(test.notes.size(), 1U);
  EXPECT_EQ(test.notes[0],
            "sun on 2003-10-17T19:30:30Z at latitude 39.742476, longitude -105.1786: elevation 39.87208 "
            "degrees, azimuth 194.34015 from true north, and the same from grid north (meridian convergence "
            "0: the map names no coordinate system)");
  EXPECT_TRUE(load(scene(sun_text(R"("azimuth": 3)"))).tests.at(0).notes.empty());
}

TEST_F(TimedSun, OnAMapWithAGeoreferenceCountsFromGridNorth) {
  write("testcases/m.png", "x");
  const std::string file = R"({"file": "m.png"})";
  vocabulary.map_centre = [](const FileTerrain& terrain) {
    EXPECT_TRUE(terrain.path.ends_with("m.png"));
    return MapCentre{{39.742476, -105.1786}, 2.5};
  };
  const std::string here = sun_text(R"("time": "2003-10-17T19:30:30Z")");
  const Scene test = load(scene(here, file)).tests.at(0);
  EXPECT_NEAR(test.sun.azimuth, 194.340241 - 2.5, 0.0003);
  EXPECT_NEAR(test.sun.elevation, 39.872046, 0.0003);
  EXPECT_NE(test.notes.at(0).find(
                "191.84015 from grid north (meridian convergence +2.50000: in the middle of the map, "
                "grid north lies 2.50000 degrees clockwise, east of true north)"),
            std::string::npos)
      << test.notes[0];
  // A place that is given wins, and the map keeps its grid.
  const Scene elsewhere =
      load(scene(sun_text(R"("time": "2003-10-17T19:30:30Z", "latitude": 0, "longitude": 0)"), file))
          .tests.at(0);
  const ephemeris::SunPosition position = ephemeris::sun_position({2003, 10, 17, 19, 30, 30, 0}, {0, 0});
  EXPECT_NEAR(elsewhere.sun.azimuth, position.azimuth - 2.5, 1e-9);
  // A procedural map is nowhere.
  EXPECT_NE(errors(scene(here)), "");
}

TEST_F(TimedSun, AzimuthStaysInTheCircleWhereConvergenceTurnsItBeyondNorth) {
  const SunTime noon{{2024, 6, 21, 12, 1, 57, 0}, ephemeris::Place{-47, 0}, false};  // in the north
  for (const double convergence : {-1.0, 1.0}) {
    const std::optional<SunOnMap> sun = sun_at(noon, MapCentre{{}, convergence});
    ASSERT_TRUE(sun);
    EXPECT_GE(sun->sun.azimuth, 0);
    EXPECT_LT(sun->sun.azimuth, 360);
    EXPECT_NEAR(std::remainder(sun->sun.azimuth + convergence, 360.0), 0, 0.05);
  }
  EXPECT_FALSE(sun_at({{2024, 6, 21, 12, 0, 0, 0}}, std::nullopt));
}

TEST_F(TimedSun, CanonicalJsonKeepsTheTimeInOneSpelling) {
  const auto canonical = [&](const std::string& members) {
    return load(scene(sun_text(members))).tests.at(0).canonical_json;
  };
  const std::string place = R"(, "latitude": 10, "longitude": 20)";
  const std::string plain = canonical(R"("time": "2024-06-21T12:00:00Z")" + place);
  EXPECT_NE(plain.find(R"("2024-06-21T12:00:00Z")"), std::string::npos) << plain;
  EXPECT_EQ(plain.find("azimuth"), std::string::npos) << plain;
  EXPECT_EQ(canonical(R"("refraction": false, "time": "2024-06-21T12:00Z")" + place), plain);
  EXPECT_NE(canonical(R"("refraction": true, "time": "2024-06-21T12:00Z")" + place), plain);
  EXPECT_NE(canonical(R"("time": "2024-06-21T12:00:00.5Z")" + place), plain);
  EXPECT_NE(canonical(R"("time": "2024-06-21T12:00Z", "latitude": 10, "longitude": 21)"), plain);
}

TEST_F(TimedSun, ReplacesAnglesAndIsReplacedByThem) {
  const std::vector<std::string> time{"sun.time=2003-10-17T19:30:30Z", "sun.latitude=39.742476",
                                      "sun.longitude=-105.1786"};
  for (const char* before : {R"("azimuth": 10, "elevation": 5)", R"("direction": [0, 0, 1])"})
    EXPECT_NEAR(load(scene(sun_text(before)), time).tests.at(0).sun.azimuth, 194.340241, 0.0003) << before;
  EXPECT_NEAR(load(scene(), time).tests.at(0).sun.azimuth, 194.340241, 0.0003);
  const Scene back = load(scene(sun_text(kNrel)), {"sun.elevation=5"}).tests.at(0);
  EXPECT_EQ(back.sun.azimuth, Sun{}.azimuth);
  EXPECT_EQ(back.sun.elevation, 5);
  EXPECT_FALSE(back.sun.time);
  const LoadResult hours = load(scene(sun_text(kNrel) + R"(,
      "matrix": {"sun.time": ["2003-10-17T18:30:30Z", "2003-10-17T19:30:30Z"]})"));
  ASSERT_EQ(listing(hours), "");
  EXPECT_EQ(hours.tests.at(0).id, "s@time=2003-10-17T18_30_30Z");
  EXPECT_LT(hours.tests.at(0).sun.azimuth, 180);
  EXPECT_GT(hours.tests.at(1).sun.azimuth, 180);
}

TEST_F(TimedSun, MistakesAreLocated) {
  const auto sun = [&](const std::string& members) { return errors(scene(sun_text(members))); };
  EXPECT_EQ(sun(R"("time": "2023-02-29T12:00:00Z", "latitude": 1, "longitude": 2)"),
            "s.json:3:17: error: /sun/time: expected a time in UTC such as 2024-06-21T12:00:00Z, got "
            "\"2023-02-29T12:00:00Z\": February 2023 has the days 01 to 28");
  EXPECT_EQ(
      sun(R"("time": "2024-06-21T12:00:00", "latitude": 1, "longitude": 2)"),
      "s.json:3:17: error: /sun/time: expected a time in UTC such as 2024-06-21T12:00:00Z, got "
      "\"2024-06-21T12:00:00\": the Z at the end is missing, which says that it is UTC and no local time");
  EXPECT_EQ(sun(R"("time": "2024-06-21T12:00:00Z")"),
            "s.json:3:8: error: /sun: the place is missing: give \"latitude\" and \"longitude\" beside "
            "\"time\", in degrees; the terrain does not say where on the earth it lies");
  EXPECT_EQ(sun(R"("time": "2024-06-21T12:00:00Z", "latitude": 47)"),
            "s.json:3:53: error: /sun/latitude: \"latitude\" alone is no place: give \"longitude\" too");
  EXPECT_EQ(
      sun(R"("time": "2024-06-21T12:00:00Z", "latitude": 91, "longitude": -181)"),
      "s.json:3:53: error: /sun/latitude: expected a number from -90 to 90 (degrees), got 91. Where: "
      "geodetic latitude of the map, north positive.\n"
      "s.json:3:70: error: /sun/longitude: expected a number from -180 to 180 (degrees), got -181. Where: "
      "longitude of the map, east positive.");
  EXPECT_EQ(
      sun(R"("time": 2024, "latitude": 1, "longitude": 2)"),
      "s.json:3:17: error: /sun/time: expected a string that is not empty (UTC), got 2024. When, as ISO "
      "8601 writes it, YYYY-MM-DDThh:mm:ssZ, from 1900 to 2100; seconds may have a fraction or be left "
      "out.");
  EXPECT_EQ(errors(scene(), {"sun.time=yesterday", "sun.latitude=1", "sun.longitude=2"}),
            "--set sun.time: error: /sun/time: expected a time in UTC such as 2024-06-21T12:00:00Z, got "
            "\"yesterday\": it has to begin with a date, YYYY-MM-DD");
}

TEST_F(TimedSun, DoesNotMixWithTheOtherAlternatives) {
  const auto sun = [&](const std::string& members) { return errors(scene(sun_text(members))); };
  EXPECT_EQ(
      sun(std::string(kNrel) + R"(, "azimuth": 5)"),
      "s.json:3:88: error: /sun/azimuth: \"azimuth\" does not go together with \"time\": give one or the "
      "other");
  EXPECT_EQ(sun(R"("azimuth": 5, "refraction": true)"),
            "s.json:3:23: error: /sun/refraction: \"refraction\" needs \"time\" beside it");
  EXPECT_EQ(errors(scene(sun_text(R"("azimuth": 5)")), {"sun.latitude=3"}),
            "--set sun.latitude: error: /sun/latitude: \"latitude\" needs \"time\" beside it");
}

}  // namespace
}  // namespace gnomon::scene
