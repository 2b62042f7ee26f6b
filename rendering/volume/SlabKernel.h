// The kernel of thick slices, in the namespace FENESTRA_SLAB_KERNEL. SlabKernels.cpp includes this once for each kind
// of processor, each time compiled for its instructions; hence no guard against a second inclusion.
//
// It walks the lines of neighbouring pixels from cell to cell, one in each lane of a vector.

namespace fenestra::FENESTRA_SLAB_KERNEL {

template <class T>
struct Lanes;
template <>
struct Lanes<std::int16_t> {
  static constexpr int count = 8;
  using Real = float;  ///< holds 16 bits with 8 to spare
  using Whole = std::int32_t;
  typedef Real Numbers __attribute__((vector_size(32)));
  typedef Whole Wholes __attribute__((vector_size(32)));
};
template <>
struct Lanes<double> {
  static constexpr int count = 4;
  using Real = double;
  using Whole = std::int64_t;
  typedef Real Numbers __attribute__((vector_size(32)));
  typedef Whole Wholes __attribute__((vector_size(32)));
};

template <class T, bool mean>
struct LineWalk {
  using Real = typename Lanes<T>::Real;
  using Whole = typename Lanes<T>::Whole;
  using Numbers = typename Lanes<T>::Numbers;
  using Wholes = typename Lanes<T>::Wholes;
  static constexpr int count = Lanes<T>::count;
  static constexpr Real never = Real(1e30);

  const SlabLines& lines;
  const SlabBox& box;
  const T* voxels = static_cast<const T*>(box.voxels);
  Real along[3], perVoxel[3];  ///< voxels a mm, and mm a voxel; 0 where the lines do not follow the axis
  // What follows is kept for each line of this batch, within this piece:
  Numbers fraction[3] = {};  ///< position at the start, counted from the first cell
  Numbers crossing[3] = {};  ///< mm from the start to the next crossing into the neighbour along each axis
  Numbers length = {};       ///< mm
  Wholes offset = {};        ///< of the cell's first voxel
  Numbers extreme = {}, sum = {}, passed = {};

  LineWalk(const SlabLines& l, const SlabBox& b) : lines(l), box(b) {
    for (int axis = 0; axis < 3; ++axis) {
      along[axis] = static_cast<Real>(lines.along[axis]);
      perVoxel[axis] = static_cast<Real>(lines.along[axis] == 0.0 ? 0.0 : 1.0 / std::abs(lines.along[axis]));
    }
  }

  static bool any(const Wholes& mask) {
#ifdef FENESTRA_SLAB_AVX2
    if constexpr (sizeof(Whole) == 4)
      return _mm256_movemask_ps((__m256)mask) != 0;
    else
      return _mm256_movemask_pd((__m256d)mask) != 0;
#endif
    Whole all = 0;
    for (int lane = 0; lane < count; ++lane) all |= mask[lane];
    return all != 0;
  }

  /// The lines of pixels (i + lane, j); those from `right` on repeat the last. False when none meets the volume.
  bool start(int i, int j, int right, double from, double to) {
    double at[3][count], begin[count], end[count];
    for (int lane = 0; lane < count; ++lane) begin[lane] = from, end[lane] = to;
    for (int axis = 0; axis < 3; ++axis) {
      const double row = lines.first[axis] + j * lines.down[axis];
      for (int lane = 0; lane < count; ++lane)
        at[axis][lane] = row + (i + lane < right ? i + lane : right - 1) * lines.right[axis];
      if (lines.along[axis] == 0.0) {
        for (int lane = 0; lane < count; ++lane) {
          const bool isInside = at[axis][lane] >= lines.low[axis] && at[axis][lane] <= lines.high[axis];
          end[lane] = isInside ? end[lane] : from;
        }
        continue;
      }
      const double mm = 1.0 / lines.along[axis];
      for (int lane = 0; lane < count; ++lane) {
        const double a = (lines.low[axis] - at[axis][lane]) * mm, b = (lines.high[axis] - at[axis][lane]) * mm;
        const double first = a < b ? a : b, last = a < b ? b : a;
        begin[lane] = first > begin[lane] ? first : begin[lane];
        end[lane] = last < end[lane] ? last : end[lane];
      }
    }
    for (int lane = 0; lane < count; ++lane)
      length[lane] = static_cast<Real>(begin[lane] < end[lane] ? end[lane] - begin[lane] : 0.0);
    if (!any(length > Numbers{})) return false;

    offset = Wholes{};
    const Whole strides[3] = {1, box.row, box.plane};
    for (int axis = 0; axis < 3; ++axis) {
      const bool descends = lines.along[axis] < 0.0;
      for (int lane = 0; lane < count; ++lane) {
        const double position = at[axis][lane] + begin[lane] * lines.along[axis] - box.first[axis];
        // A line that misses the volume stays at a place that may be read.
        const double held = begin[lane] < end[lane] ? position : 1.0;
        // The cell that the line goes into: at a border, the one behind it.
        auto cell = static_cast<Whole>(static_cast<std::int32_t>(held));
        if (descends && static_cast<double>(cell) == held) --cell;
        const double within = held - static_cast<double>(cell);
        fraction[axis][lane] = static_cast<Real>(within);
        crossing[axis][lane] = static_cast<Real>(descends ? within : 1.0 - within);
        offset[lane] += cell * strides[axis];
      }
      if (along[axis] == 0)
        crossing[axis] = Numbers{} + never;
      else
        crossing[axis] *= perVoxel[axis];
    }
    return true;
  }

  /// Two voxels beside one another along x, in each lane.
  [[gnu::always_inline]] void load(int further, Numbers& low, Numbers& high) const {
    const T* const first = voxels + further;
    if constexpr (sizeof(T) == 2) {
      // Both voxels are read at once. Instructions that gather them for all lanes take longer than this.
      Wholes pairs;
      for (int lane = 0; lane < count; ++lane) {
        std::int32_t pair;
        std::memcpy(&pair, first + offset[lane], sizeof(pair));
        pairs[lane] = pair;
      }
      low = __builtin_convertvector((pairs << 16) >> 16, Numbers);
      high = __builtin_convertvector(pairs >> 16, Numbers);
    } else {
      for (int lane = 0; lane < count; ++lane) {
        low[lane] = first[offset[lane]];
        high[lane] = first[offset[lane] + 1];
      }
    }
  }

  /// The Bernstein coefficients of the field along the lines, from their entries into a cell to their exits, whose
  /// positions within it are `in` and `out`.
  [[gnu::always_inline]] void coefficients(const Numbers (&in)[3], const Numbers (&out)[3], Numbers (&b)[4]) const {
    Numbers planes[2][2][2];  // [z of the voxels][x in, out][y in, out]
    for (int z = 0; z < 2; ++z) {
      Numbers rows[2][2];  // [y of the voxels][x in, out]
      for (int y = 0; y < 2; ++y) {
        Numbers low, high;
        load(y * box.row + z * box.plane, low, high);
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

  [[gnu::always_inline]] void raiseWithin(const Numbers (&b)[4]) {
    // A third of the derivative, a·t² + 2·h·t + c, falls through zero where the cubic is greatest. Where it does not,
    // another place of the line does no harm.
    const Numbers zero = {}, one = zero + 1;
    const Numbers d0 = b[1] - b[0], d1 = b[2] - b[1], d2 = b[3] - b[2];
    const Numbers a = (d0 - d1) + (d2 - d1), h = d1 - d0, c = d0;
    Numbers root = h * h - a * c;
    root = root > zero ? root : zero;
    squareRoot(root);
    const Wholes rises = h >= zero;
    Numbers t = (rises ? -(h + root) : c) / (rises ? a : root - h);
    t = t > zero ? t : zero;
    t = t < one ? t : one;
    const Numbers s = one - t;
    const Numbers value = s * s * (s * b[0] + 3 * t * b[1]) + t * t * (3 * s * b[2] + t * b[3]);
    extreme = value > extreme ? value : extreme;
  }

  static void squareRoot(Numbers& of) {
#ifdef FENESTRA_SLAB_AVX2
    if constexpr (sizeof(Real) == 4)
      of = (Numbers)_mm256_sqrt_ps((__m256)of);
    else
      of = (Numbers)_mm256_sqrt_pd((__m256d)of);
#else
    for (int lane = 0; lane < count; ++lane) of[lane] = std::sqrt(of[lane]);
#endif
  }

  void walk() {
    const Numbers zero = {};
    const Real sign = static_cast<Real>(lines.sign);
    const Whole steps[3] = {lines.along[0] < 0.0 ? -1 : 1, lines.along[1] < 0.0 ? -box.row : box.row,
                            lines.along[2] < 0.0 ? -box.plane : box.plane};
    Numbers at = {};
    while (true) {
      Numbers exit = crossing[0] < crossing[1] ? crossing[0] : crossing[1];
      exit = crossing[2] < exit ? crossing[2] : exit;
      exit = length < exit ? length : exit;
      Numbers in[3], out[3];
      for (int axis = 0; axis < 3; ++axis) {
        // Rounding may leave a position outside its cell by a millionth, which does no harm.
        in[axis] = fraction[axis] + along[axis] * at;
        out[axis] = fraction[axis] + along[axis] * exit;
      }
      Numbers b[4];
      coefficients(in, out, b);
      if constexpr (mean) {
        const Numbers all = (b[0] + b[1]) + (b[2] + b[3]), way = exit - at;
        const Wholes isNumber = all == all;
        sum += isNumber ? all * way : zero;
        passed += isNumber ? way : zero;
      } else {
        for (int k = 0; k < 4; ++k) b[k] *= sign;
        raise(b);
      }
      at = exit;
      if (!any(at < length)) break;
      for (int axis = 0; axis < 3; ++axis) {
        const Wholes crosses = crossing[axis] <= exit;
        const Numbers next = crossing[axis] + perVoxel[axis],
                      back = fraction[axis] - (along[axis] < 0 ? Real(-1) : Real(1));
        offset += crosses & steps[axis];
        crossing[axis] = crosses ? next : crossing[axis];
        fraction[axis] = crosses ? back : fraction[axis];
      }
    }
  }
};

template <class T, bool mean>
void slabKernel(const SlabLines& lines, const SlabBox& box, const SlabTile& tile, double from, double to,
                SlabSums& sums) {
  using Walk = LineWalk<T, mean>;
  Walk walk(lines, box);
  const int width = tile.right - tile.left;
  for (int j = tile.top; j < tile.bottom; ++j)
    for (int i = tile.left; i < tile.right; i += Walk::count) {
      if (!walk.start(i, j, tile.right, from, to)) continue;
      walk.extreme = walk.sum = walk.passed = typename Walk::Numbers{};
      walk.extreme -= std::numeric_limits<typename Walk::Real>::infinity();
      walk.walk();
      for (int lane = 0; lane < Walk::count && i + lane < tile.right; ++lane) {
        if (!(walk.length[lane] > 0)) continue;
        const int pixel = (j - tile.top) * width + i - tile.left + lane;
        if constexpr (mean) {
          sums.sum[pixel] += 0.25 * static_cast<double>(walk.sum[lane]);
          sums.length[pixel] += static_cast<double>(walk.passed[lane]);
        } else if (static_cast<double>(walk.extreme[lane]) > sums.extreme[pixel])
          sums.extreme[pixel] = static_cast<double>(walk.extreme[lane]);
      }
    }
}

}  // namespace fenestra::FENESTRA_SLAB_KERNEL
