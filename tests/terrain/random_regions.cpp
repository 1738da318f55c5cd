#include "random_regions.h"

#include <array>
#include <cstddef>
#include <random>
#include <sstream>

namespace talus::test {
namespace {

// Draws one after another, each by a statement of its own: the order of arguments is the compiler's.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : engine_{seed} {}

  double real(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) / 9007199254740992.0;
  }
  int whole(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
  }
  bool chance(int percent) { return whole(1, 100) <= percent; }
  template <std::size_t N>
  const char* one_of(const std::array<const char*, N>& names) {
    return names[static_cast<std::size_t>(whole(0, static_cast<int>(N) - 1))];
  }

 private:
  std::mt19937_64 engine_;
};

class RegionsWriter {
 public:
  explicit RegionsWriter(std::uint64_t seed) : draws_{seed} {
    text_.precision(6);
    text_ << "seed = " << (seed >> 1) << "\n";
  }

  std::string write() {
    const int resolution = draws_.chance(70) ? 1 : 2;
    const int seas = draws_.whole(1, 3);
    text_ << "resolution = " << resolution << "\nsea_level = " << 64.0 * seas / resolution
          << "\nstrata_wavelength = " << draws_.real(100, 600) << "\n";
    const bool erodes = draws_.chance(12);
    if (erodes) text_ << "method = \"erosion\"\nerosion_steps = " << draws_.whole(1, 5) << "\n";
    fields();
    surface();
    strata();
    loose();
    looks();
    if (draws_.chance(20)) caves();
    if (!erodes && draws_.chance(50)) objects();
    return text_.str();
  }

 private:
  void fields() {
    const int count = draws_.whole(0, 3);
    for (int i = 0; i < count; ++i) {
      const int octaves = draws_.whole(1, 3);
      text_ << "[[field]]\nname = \"own " << i << "\"\nwavelength = " << draws_.real(300, 6000)
            << "\noctaves = " << octaves << "\ngain = ";
      text_ << draws_.real(0.2, 0.8) << "\nwarp = ";
      text_ << draws_.whole(0, 1) << "\n";
    }
    own_fields_ = count;
  }

  void curve(const char* key, double low, double high) {
    text_ << key << " = [";
    double x = -1.2;
    const int knots = draws_.whole(1, 6);
    for (int i = 0; i < knots; ++i) {
      x += draws_.real(0.05, 0.5);
      text_ << (i == 0 ? "[" : ", [") << x << ", ";
      text_ << draws_.real(low, high) << "]";
    }
    text_ << "]\n";
  }

  void surface() {
    text_ << "[surface]\nkind = \"regions\"\n[surface.land]\n";
    if (own_fields_ > 0 && draws_.chance(30)) text_ << "field = \"own 0\"\n";
    if (draws_.chance(60)) curve("height", -60, 60);
    if (draws_.chance(40)) curve("inland", 0, 1);
    text_ << "[surface.ranges]\nrelief = " << draws_.real(0, 300) << "\n";
    if (draws_.chance(40)) curve("belt", 0, 1);
    text_ << "[surface.hills]\n";
    if (draws_.chance(50)) curve("height", 0, 120);
    text_ << "[surface.mesas]\nheight = " << draws_.real(0, 130) << "\nanywhere = ";
    text_ << draws_.real(0, 1) << "\n";
    if (draws_.chance(40)) curve("terraces", 0, 1);
    text_ << "[surface.climate]\nwarmer = " << draws_.real(-0.6, 0.6) << "\nwetter = ";
    text_ << draws_.real(-0.6, 0.6) << "\nlapse = ";
    text_ << draws_.real(60, 400) << "\n";
    text_ << "[surface.rivers]\nwavelength = " << draws_.real(1200, 5000) << "\nbed = ";
    text_ << draws_.real(0, 9) << "\n";
  }

  void strata() {
    repeat_ = draws_.chance(50);
    text_ << "[strata]\nrepeat = " << (repeat_ ? "true" : "false") << "\n";
    if (draws_.chance(50)) text_ << "octaves = " << draws_.whole(1, 4) << "\n";
    layers_ = draws_.whole(2, 6);
    for (int i = 0; i < layers_; ++i) {
      text_ << "[[stratified]]\nname = \"rock " << i << "\"\ncolour = \"#777777\"\n";
      if (repeat_) {
        text_ << (i + 1 == layers_ ? "band = true\n" : "");
      } else {
        text_ << "depth = " << 900 - 150 * i << "\n";
      }
      text_ << "thickness = " << draws_.real(8, 60) << "\nroughness = ";
      text_ << draws_.real(0, 0.9) << "\n";
    }
  }

  std::string quantity(bool late) {
    static constexpr std::array kEarly{"height", "temperature", "moisture", "mesas",
                                       "ranges", "base",        "terraces"};
    static constexpr std::array kAll{"height", "temperature", "moisture", "mesas", "ranges",
                                     "base",   "terraces",    "slope",    "cliff"};
    if (own_fields_ > 0 && draws_.chance(25))
      return "\"own " + std::to_string(draws_.whole(0, own_fields_ - 1)) + "\"";
    return late ? draws_.one_of(kAll) : draws_.one_of(kEarly);
  }

  double value_of(const std::string& quantity) {
    if (quantity == "height" || quantity == "base") return draws_.real(-30, 120);
    if (quantity == "slope") return draws_.real(0, 70);
    if (quantity == "cliff" || quantity == "mesas" || quantity == "ranges") return draws_.real(0, 1);
    return draws_.real(-0.8, 0.8);
  }

  void loose() {
    loose_ = draws_.whole(1, 3);
    for (int i = 0; i < loose_; ++i) {
      text_ << "[[eroded]]\nname = \"loose " << i << "\"\ncolour = \"#777777\"\nweight = " << loose_ - i
            << "\nthickness = " << draws_.real(0.5, 8) << "\nangle_of_repose = ";
      text_ << draws_.real(25, 45) << "\nmax_slope = ";
      text_ << draws_.real(35, 60) << "\n";
      if (!draws_.chance(60)) continue;
      const std::string by = quantity(true);
      const double first = value_of(by);
      text_ << "where = { " << by << " = [" << first << ", ";
      text_ << value_of(by) << "] }\n";
    }
    if (!draws_.chance(50)) return;
    text_ << "[talus]\nof = \"loose 0\"\nthickness = " << draws_.real(0, 12) << "\nshare = ";
    text_ << draws_.real(0, 1) << "\nreach = ";
    text_ << draws_.real(1, 12) << "\ncliff = ";
    text_ << draws_.real(0, 16) << "\n";
  }

  bool conditions() {
    bool any = false;
    for (const char* const key : {"below", "above"}) {
      if (!draws_.chance(60)) continue;
      any = true;
      const std::string by = quantity(false);
      text_ << key << " = { " << by << " = " << value_of(by) << " }\n";
    }
    return any;
  }

  void looks() {
    const int count = draws_.whole(0, 6);
    for (int i = 0; i < count; ++i) {
      text_ << "[[look]]\nname = \"look " << i << "\"\nof = \"loose " << draws_.whole(0, loose_ - 1)
            << "\"\n";
      // What stands behind a look without any is refused.
      if (!conditions()) text_ << "above = { height = -32768 }\n";
      text_ << "colour = \"#123456\"\n";
    }
    if (draws_.chance(40)) {
      text_ << "[[look]]\nname = \"ice\"\nof = \"water\"\n";
      (void)conditions();
      text_ << "colour = \"#abcdef\"\n";
    }
    const int provinces = draws_.whole(0, 2);
    for (int i = 0; i < provinces; ++i) {
      text_ << "[[province]]\nname = \"province " << i << "\"\n";
      (void)conditions();
      text_ << "colours = { \"rock " << draws_.whole(1, layers_ - 1) << "\" = \"#00ff00\" }\n";
    }
  }

  void caves() {
    text_ << "[caves]\nlow = 30\nhigh = 150\nclimb_wavelength = 300\nwavelength = 150\nwidth = 12\nheight = "
             "14\n"
             "chamber_wavelength = 120\nchamber_threshold = 0.3\nchamber_height = 24\nroof = 3\nspan = 16\n";
  }

  void objects() {
    static constexpr std::array kTrees{"conifer", "broadleaf", "acacia", "jungle_tree"};
    const int count = draws_.whole(1, 3);
    for (int i = 0; i < count; ++i) {
      text_ << "[[object]]\nname = \"object " << i << "\"\nmodel = \"" << draws_.one_of(kTrees)
            << "\"\nspacing = " << draws_.whole(5, 14);
      text_ << "\nchance = " << draws_.real(0, 1) << "\n";
      if (draws_.chance(50)) text_ << "clumps = \"" << (draws_.chance(50) ? "woods" : "groves") << "\"\n";
      if (draws_.chance(50)) {
        const std::string by = quantity(true);
        const double first = value_of(by);
        text_ << "where = { " << by << " = [" << first << ", ";
        text_ << value_of(by) << "] }\n";
      }
      text_ << "wood = { name = \"rock 0\" }\nleaves = { name = \"leaves " << i
            << "\", colour = \"#00aa00\" }\n";
    }
  }

  Draws draws_;
  std::ostringstream text_;
  int own_fields_ = 0;
  int layers_ = 0;
  int loose_ = 0;
  bool repeat_ = false;
};

}  // namespace

std::string random_regions_text(std::uint64_t seed) {
  return RegionsWriter{seed}.write();
}

}  // namespace talus::test
