#include "droplet_erosion.h"

#include <algorithm>
#include <cmath>

#include <talus/terrain/lattice_hash.h>

namespace talus::tools {
namespace {

constexpr double kInertia = 0.05;  // share of its direction that a droplet keeps per step
constexpr double kCapacity = 2;    // ground carried per unit of water, speed and fall
constexpr double kMinCapacity = 0.0002;
constexpr double kErosion = 0.1;       // share of the free capacity filled per step
constexpr double kDeposition = 0.1;    // share of the excess deposited per step
constexpr double kEvaporation = 0.02;  // share of the water lost per step
constexpr double kGravity = 4;
constexpr int kMaxLife = 64;     // steps of one cell
constexpr int kBrushRadius = 3;  // cells; eroding a single cell would dig a pit
constexpr std::uint64_t kBetweenReports = 1024;

struct Droplet {
  double x = 0;
  double z = 0;
  double towards_x = 0;
  double towards_z = 0;
  double speed = 1;
  double water = 1;
  double carried = 0;
};

// Position of a point among its four samples.
struct Cell {
  std::size_t north_west = 0;
  double u = 0;
  double v = 0;
};

struct Ground {
  double height = 0;
  double east = 0;  // rise eastward
  double south = 0;
};

class Slopes {
 public:
  explicit Slopes(HeightGrid& grid) : grid_{grid}, width_{static_cast<std::size_t>(grid.width)} {
    for (int z = -kBrushRadius; z <= kBrushRadius; ++z) {
      for (int x = -kBrushRadius; x <= kBrushRadius; ++x) {
        const double weight = kBrushRadius - std::sqrt(static_cast<double>(x * x + z * z));
        if (weight <= 0) continue;
        brush_.push_back({x, z, weight});
        brush_sum_ += weight;
      }
    }
  }

  void run(Droplet drop) {
    for (int step = 0; step < kMaxLife; ++step) {
      const Ground here = ground(drop.x, drop.z);
      drop.towards_x = drop.towards_x * kInertia - here.east * (1 - kInertia);
      drop.towards_z = drop.towards_z * kInertia - here.south * (1 - kInertia);
      const double length = std::sqrt(drop.towards_x * drop.towards_x + drop.towards_z * drop.towards_z);
      if (length < 1e-12) break;  // level ground
      drop.towards_x /= length;
      drop.towards_z /= length;
      const double x = drop.x + drop.towards_x;
      const double z = drop.z + drop.towards_z;
      if (!(x >= 0 && z >= 0 && x < grid_.width - 1 && z < grid_.depth - 1)) return;
      const double rise = ground(x, z).height - here.height;
      exchange(drop, rise);
      drop.x = x;
      drop.z = z;
      drop.speed = std::sqrt(std::max(0.0, drop.speed * drop.speed - rise * kGravity));
      drop.water *= 1 - kEvaporation;
    }
    lay_down(drop, drop.carried);
  }

 private:
  struct Bristle {
    int x;
    int z;
    double weight;
  };

  void exchange(Droplet& drop, double rise) {
    const double capacity = std::max(-rise * drop.speed * drop.water * kCapacity, kMinCapacity);
    if (rise > 0) return lay_down(drop, std::min(rise, drop.carried));  // fills the pit that it leaves
    if (drop.carried > capacity) return lay_down(drop, (drop.carried - capacity) * kDeposition);
    // A droplet takes at most the height it falls, or it would dig a pit behind itself.
    take_up(drop, std::min((capacity - drop.carried) * kErosion, -rise));
  }

  [[nodiscard]] Cell cell_of(double x, double z) const {
    const auto column = static_cast<std::size_t>(x);
    const auto row = static_cast<std::size_t>(z);
    return {row * width_ + column, x - static_cast<double>(column), z - static_cast<double>(row)};
  }

  [[nodiscard]] Ground ground(double x, double z) const {
    const Cell cell = cell_of(x, z);
    const double* h = grid_.heights.data() + cell.north_west;
    const double north = h[0] + cell.u * (h[1] - h[0]);
    const double south = h[width_] + cell.u * (h[width_ + 1] - h[width_]);
    const double rise_north = h[1] - h[0];
    const double rise_south = h[width_ + 1] - h[width_];
    return {north + cell.v * (south - north), rise_north + cell.v * (rise_south - rise_north), south - north};
  }

  void lay_down(Droplet& drop, double amount) {
    const Cell cell = cell_of(drop.x, drop.z);
    double* h = grid_.heights.data() + cell.north_west;
    h[0] += amount * (1 - cell.u) * (1 - cell.v);
    h[1] += amount * cell.u * (1 - cell.v);
    h[width_] += amount * (1 - cell.u) * cell.v;
    h[width_ + 1] += amount * cell.u * cell.v;
    drop.carried -= amount;
  }

  void take_up(Droplet& drop, double amount) {
    const int x = static_cast<int>(drop.x);
    const int z = static_cast<int>(drop.z);
    for (const Bristle& bristle : brush_) {
      const int at_x = x + bristle.x;
      const int at_z = z + bristle.z;
      if (at_x < 0 || at_z < 0 || at_x >= grid_.width || at_z >= grid_.depth) continue;
      double& height =
          grid_.heights[static_cast<std::size_t>(at_z) * width_ + static_cast<std::size_t>(at_x)];
      const double taken = std::min(amount * bristle.weight / brush_sum_, std::max(0.0, height));
      height -= taken;
      drop.carried += taken;
    }
  }

  HeightGrid& grid_;
  std::size_t width_;
  std::vector<Bristle> brush_;
  double brush_sum_ = 0;
};

// 0 (inclusive) to 1 (exclusive).
double part(std::uint64_t hash) {
  return static_cast<double>(hash >> 11) / 9007199254740992.0;
}

}  // namespace

void erode(HeightGrid& grid, const DropletOptions& options, ProgressBar& progress) {
  const auto [least, greatest] = std::minmax_element(grid.heights.begin(), grid.heights.end());
  const double floor = *least;
  const double relief = *greatest - floor;
  if (!(relief > 0)) return;
  for (double& height : grid.heights) height = (height - floor) / relief;
  progress.expect(options.droplets);
  Slopes slopes{grid};
  for (std::uint64_t i = 0; i < options.droplets; ++i) {
    const std::uint64_t place = terrain::derived_seed(options.seed, i);
    Droplet drop;
    drop.x = part(place) * (grid.width - 1);
    drop.z = part(terrain::mix64(place)) * (grid.depth - 1);
    slopes.run(drop);
    if (i % kBetweenReports == 0) progress.advance(kBetweenReports);
  }
  for (double& height : grid.heights) height = floor + height * relief;
}

}  // namespace talus::tools
