// The kernel of thick slices, in the namespace FENESTRA_SLAB_KERNEL. SlabKernels.cpp includes this once for each kind
// of processor, each time compiled for its instructions; hence no guard against a second inclusion.
//
// It walks the lines of neighbouring pixels from cell to cell, one in each lane of a vector. All lines are parallel.

namespace fenestra::FENESTRA_SLAB_KERNEL {

template <class Real>
struct Lanes;
template <>
struct Lanes<float> {
  static constexpr int count = 8;
  using Whole = std::int32_t;
  typedef float Numbers __attribute__((vector_size(32)));
  typedef std::int32_t Wholes __attribute__((vector_size(32)));
};
template <>
struct Lanes<double> {
  static constexpr int count = 4;
  using Whole = std::int64_t;
  typedef double Numbers __attribute__((vector_size(32)));
  typedef std::int64_t Wholes __attribute__((vector_size(32)));
};

/// The lines of some pixels beside one another, within one piece of their length.
template <class Real>
struct LaneStart {
  static constexpr int count = Lanes<Real>::count;
  typename Lanes<Real>::Numbers fraction[3];       ///< position within the first cell
  typename Lanes<Real>::Numbers crossing[3];       ///< mm to the first crossing into the next cell of each axis
  typename Lanes<Real>::Wholes least[3], most[3];  ///< the volume's cells of whole voxels, counted from the first cell
  typename Lanes<Real>::Numbers length;            ///< mm
  std::ptrdiff_t offset[count];                    ///< of the first cell's voxel; may lie outside the volume
};

template <class T, bool mean>
struct LineWalk {
  using Real = std::conditional_t<sizeof(T) <= 2, float, double>;
  using Numbers = typename Lanes<Real>::Numbers;
  using Wholes = typename Lanes<Real>::Wholes;
  static constexpr int count = Lanes<Real>::count;

  const SlabJob& job;
  double position[3][count];        ///< where the lines cross the slice
  double begin[count], end[count];  ///< their parts within the volume, mm from the slice; begin > end: none
  Numbers extreme = {};
  double sum[count] = {}, length[count] = {};

  explicit LineWalk(const SlabJob& of) : job(of) { extreme -= std::numeric_limits<Real>::infinity(); }

  static bool any(const Wholes& mask) {
    typename Lanes<Real>::Whole all = 0;
    for (int lane = 0; lane < count; ++lane) all |= mask[lane];
    return all != 0;
  }

  /// The lines of pixels (i + lane, j); those beyond `right` repeat the last.
  void clip(int i, int j, int right) {
    for (int lane = 0; lane < count; ++lane) {
      const int column = i + lane < right ? i + lane : right - 1;
      begin[lane] = -job.half;
      end[lane] = job.half;
      for (int axis = 0; axis < 3; ++axis) {
        const double at = job.first[axis] + column * job.right[axis] + j * job.down[axis];
        position[axis][lane] = at;
        const double low = -0.5 - at, high = job.dims[axis] - 0.5 - at;
        if (job.along[axis] == 0.0) {
          if (!(low <= 0.0 && high >= 0.0)) end[lane] = -std::numeric_limits<double>::infinity();
          continue;
        }
        const double a = low / job.along[axis], b = high / job.along[axis];
        const double from = a < b ? a : b, to = a < b ? b : a;
        begin[lane] = from > begin[lane] ? from : begin[lane];
        end[lane] = to < end[lane] ? to : end[lane];
      }
    }
  }

  /// False when all lines have ended before `piece`.
  bool startPiece(int piece, LaneStart<Real>& start) const {
    bool isAny = false;
    for (int lane = 0; lane < count; ++lane) {
      double from = begin[lane] + piece * job.piece, to = from + job.piece;
      to = to < end[lane] ? to : end[lane];
      isAny = isAny || from < to;
      // A line that has ended, or never met the volume, stays at a place that may be read.
      if (!(from < to)) from = to = begin[lane] <= end[lane] ? end[lane] : 0.0;
      start.length[lane] = static_cast<Real>(to - from);
      start.offset[lane] = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const double along = job.along[axis], at = position[axis][lane] + from * along;
        // The cell that the line goes into. The half voxel before the first centre is the cell -1.
        double cell = along < 0.0 ? std::ceil(at) - 1.0 : std::floor(at);
        cell = cell < job.dims[axis] - 1 ? cell : job.dims[axis] - 1;
        cell = cell > -1.0 ? cell : -1.0;
        const auto whole = static_cast<std::ptrdiff_t>(cell);
        const double within = at - cell;
        start.fraction[axis][lane] = static_cast<Real>(within);
        const double ahead = along < 0.0 ? within : 1.0 - within;
        start.crossing[axis][lane] = static_cast<Real>(along == 0.0 ? never : ahead / std::abs(along));
        const std::ptrdiff_t last = job.dims[axis] > 1 ? job.dims[axis] - 2 : 0;
        start.least[axis][lane] = static_cast<typename Lanes<Real>::Whole>(-whole);
        start.most[axis][lane] = static_cast<typename Lanes<Real>::Whole>(last - whole);
        start.offset[lane] += whole * job.strides[axis];
      }
    }
    return isAny;
  }

  /// Two voxels beside one another along x, in each lane.
  [[gnu::always_inline]] void load(const T* const* corners, std::ptrdiff_t further, Numbers& low, Numbers& high) const {
    if constexpr (sizeof(T) == 2)
      if (job.strides[0] == 1) {
        // Both voxels are read at once.
        Wholes pairs;
        for (int lane = 0; lane < count; ++lane) {
          std::int32_t pair;
          std::memcpy(&pair, corners[lane] + further, sizeof(pair));
          pairs[lane] = pair;
        }
        constexpr int unsignedBits = std::is_signed_v<T> ? -1 : 0xffff;
        low = __builtin_convertvector(((pairs << 16) >> 16) & unsignedBits, Numbers);
        high = __builtin_convertvector((pairs >> 16) & unsignedBits, Numbers);
        return;
      }
    for (int lane = 0; lane < count; ++lane) {
      low[lane] = static_cast<Real>(corners[lane][further]);
      high[lane] = static_cast<Real>(corners[lane][further + job.strides[0]]);
    }
  }

  /// The Bernstein coefficients of the field along the lines, from their entries into a cell to their exits, whose
  /// positions within it are `in` and `out`.
  [[gnu::always_inline]] void coefficients(const T* const* corners, const Numbers (&in)[3], const Numbers (&out)[3],
                                           Numbers (&b)[4]) const {
    Numbers planes[2][2][2];  // [z of the voxels][x in, out][y in, out]
    for (int z = 0; z < 2; ++z) {
      Numbers rows[2][2];  // [y of the voxels][x in, out]
      for (int y = 0; y < 2; ++y) {
        Numbers low, high;
        load(corners, y * job.strides[1] + z * job.strides[2], low, high);
        const Numbers rise = high - low;
        rows[y][0] = low + in[0] * rise;
        rows[y][1] = low + out[0] * rise;
      }
      for (int x = 0; x < 2; ++x) {
        const Numbers rise = rows[1][x] - rows[0][x];
        planes[z][x][0] = rows[0][x] + in[1] * rise;
        planes[z][x][1] = rows[0][x] + out[1] * rise;
      }
    }
    Numbers at[2][2][2];  // [x in, out][y in, out][z in, out]
    for (int x = 0; x < 2; ++x)
      for (int y = 0; y < 2; ++y) {
        const Numbers rise = planes[1][x][y] - planes[0][x][y];
        at[x][y][0] = planes[0][x][y] + in[2] * rise;
        at[x][y][1] = planes[0][x][y] + out[2] * rise;
      }
    constexpr Real third = Real(1) / Real(3);
    b[0] = at[0][0][0];
    b[1] = third * (at[1][0][0] + at[0][1][0] + at[0][0][1]);
    b[2] = third * (at[1][1][0] + at[1][0][1] + at[0][1][1]);
    b[3] = at[1][1][1];
  }

  /// Raises the extreme to the greatest value of the cubics. A cubic lies below the greatest of its coefficients.
  [[gnu::always_inline]] void raise(const Numbers (&b)[4]) {
    const Numbers low = b[0] > b[3] ? b[0] : b[3], high = b[1] > b[2] ? b[1] : b[2];
    extreme = low > extreme ? low : extreme;
    if (any(high > extreme)) raiseWithin(b);
  }

  void raiseWithin(const Numbers (&b)[4]) {
    for (int lane = 0; lane < count; ++lane) {
      const Real b0 = b[0][lane], b1 = b[1][lane], b2 = b[2][lane], b3 = b[3][lane];
      if (!(b1 > extreme[lane] || b2 > extreme[lane])) continue;
      // A third of the derivative, a·t² + 2·h·t + c, falls through zero where the cubic is greatest.
      const Real d0 = b1 - b0, d1 = b2 - b1, d2 = b3 - b2;
      const Real a = d0 - 2 * d1 + d2, h = d1 - d0, c = d0;
      const Real squared = h * h - a * c;
      if (!(squared >= 0)) continue;
      const Real root = std::sqrt(squared);
      const Real t = h >= 0 ? -(h + root) / a : c / (root - h);
      if (!(t > 0 && t < 1)) continue;
      const Real s = 1 - t;
      const Real value = s * s * (s * b0 + 3 * t * b1) + t * t * (3 * s * b2 + t * b3);
      if (value > extreme[lane]) extreme[lane] = value;
    }
  }

  void walkPiece(const LaneStart<Real>& start) {
    const T* const voxels = static_cast<const T*>(job.voxels);
    const Numbers zero = {}, one = zero + 1;
    Numbers at = {}, sums = {}, lengths = {};
    Numbers crossing[3] = {start.crossing[0], start.crossing[1], start.crossing[2]};
    Wholes cell[3] = {};
    const T* corners[count];
    while (true) {
      Numbers exit = crossing[0] < crossing[1] ? crossing[0] : crossing[1];
      exit = crossing[2] < exit ? crossing[2] : exit;
      exit = start.length < exit ? start.length : exit;
      Wholes offset = {};
      Numbers in[3], out[3];
      for (int axis = 0; axis < 3; ++axis) {
        // Beyond the outermost centres, the cell of whole voxels beside it is read at its border.
        Wholes read = cell[axis] > start.least[axis] ? cell[axis] : start.least[axis];
        read = read < start.most[axis] ? read : start.most[axis];
        offset += read * static_cast<typename Lanes<Real>::Whole>(job.strides[axis]);
        const Numbers base = start.fraction[axis] - __builtin_convertvector(read, Numbers);
        const Real along = static_cast<Real>(job.along[axis]);
        in[axis] = base + along * at;
        out[axis] = base + along * exit;
        for (Numbers* side : {&in[axis], &out[axis]}) {
          *side = *side > zero ? *side : zero;
          *side = *side < one ? *side : one;
        }
      }
      for (int lane = 0; lane < count; ++lane) corners[lane] = voxels + (start.offset[lane] + offset[lane]);
      Numbers b[4];
      coefficients(corners, in, out, b);
      if constexpr (mean) {
        const Numbers all = b[0] + b[1] + b[2] + b[3], passed = exit - at;
        const Wholes isNumber = all == all;
        sums += isNumber ? all * passed : zero;
        lengths += isNumber ? passed : zero;
      } else {
        const Real sign = static_cast<Real>(job.sign);
        for (Numbers& value : b) value *= sign;
        raise(b);
      }
      at = exit;
      if (!any(at < start.length)) break;
      for (int axis = 0; axis < 3; ++axis) {
        const Wholes crosses = crossing[axis] <= exit;
        cell[axis] += job.along[axis] < 0.0 ? crosses : -crosses;
        const Numbers next =
            crossing[axis] + static_cast<Real>(job.along[axis] == 0.0 ? 0.0 : 1.0 / std::abs(job.along[axis]));
        crossing[axis] = crosses ? next : crossing[axis];
      }
    }
    if constexpr (mean)
      for (int lane = 0; lane < count; ++lane) {
        sum[lane] += 0.25 * static_cast<double>(sums[lane]);
        length[lane] += static_cast<double>(lengths[lane]);
      }
  }

  /// The result in a lane, real; NaN when its line meets nothing.
  float result(int lane) const {
    const double none = std::numeric_limits<double>::quiet_NaN();
    if (!(begin[lane] <= end[lane])) return static_cast<float>(none);
    double stored;
    if constexpr (mean)
      stored = length[lane] > 0.0 ? sum[lane] / length[lane] : none;
    else
      stored = std::isinf(extreme[lane]) && extreme[lane] < 0 ? none : job.sign * static_cast<double>(extreme[lane]);
    return static_cast<float>(job.slope * stored + job.intercept);
  }

  static constexpr double never = 1e30;
};

template <class T, bool mean>
void slabTile(const SlabJob& job, const SlabTile& tile) {
  constexpr int count = LineWalk<T, mean>::count;
  for (int j = tile.top; j < tile.bottom; ++j)
    for (int i = tile.left; i < tile.right; i += count) {
      LineWalk<T, mean> walk(job);
      walk.clip(i, j, tile.right);
      LaneStart<typename LineWalk<T, mean>::Real> start;
      for (int piece = 0; walk.startPiece(piece, start); ++piece) walk.walkPiece(start);
      float* const values = job.values + static_cast<std::ptrdiff_t>(j) * job.width + i;
      for (int lane = 0; lane < count && i + lane < tile.right; ++lane) values[lane] = walk.result(lane);
    }
}

}  // namespace fenestra::FENESTRA_SLAB_KERNEL
