#pragma once
// Descriptors of views that camera placement is compared with: their definitions, and their values for the candidates.
//
// A focus has n surface points of equal area A/n (FocusSurface). For view v, d(v) is the unit direction towards the
// camera, and p(v), p(z|v), p(z) are those of the ViewChannel whose elements z are the points, each a polygon of the
// area A/n with the point's normal n_z: where v sees it, its projected area is
//
//     a_z(v) = A/n · max(0, n_z · d(v))
//
// Bordoloi and Shen state viewpoint entropy for the voxels of a volume, weighted by opacity and importance; the focus
// is drawn opaque here, so only the voxels at its surface count, and the definition is that of Vázquez et al. for
// surfaces. The background is no element. The descriptors `entropy`, `mutualInformation` and `stability` of placement
// (Placement.h) are simpler: there each seen point counts alike, however obliquely it is seen.
//
// Beside the descriptors stand the N best views and the shortest tour past them (RepresentativeViews.h).
//
// Sources:
//
//  [1] P. Vázquez, M. Feixas, M. Sbert, W. Heidrich: Viewpoint selection using viewpoint entropy. VMV 2001.
//  [2] U. Bordoloi, H.-W. Shen: View selection for volume rendering. IEEE Visualization 2005.
//  [3] I. Viola, M. Feixas, M. Sbert, M. E. Gröller: Importance-driven focus of attention. IEEE TVCG 12(5), 2006.
//  [4] M. DeWeese, M. Meister: How to measure the information gained from one symbol. Network 10(4), 1999.
//  [5] X. Bonaventura, M. Feixas, M. Sbert, L. Chuang, C. Wallraven: A survey of viewpoint selection methods for
//      polygonal models. Entropy 20(5), 2018.
//  [6] M. Feixas, M. Sbert, F. González: A unified information-theoretic framework for viewpoint selection and mesh
//      saliency. ACM Transactions on Applied Perception 6(1), 2009.
//  [7] A. Secord, J. Lu, A. Finkelstein, M. Singh, A. Nealen: Perceptual models of viewpoint preference. ACM
//      Transactions on Graphics 30(5), 2011.
//  [8] O. Polonsky, G. Patanè, S. Biasotti, C. Gotsman, M. Spagnuolo: What's in an image? The Visual Computer 21, 2005.
//  [9] T. Vieira, A. Bordignon, A. Peixoto, G. Tavares, H. Lopes, L. Velho, T. Lewiner: Learning good views through
//      intelligent galleries. Computer Graphics Forum 28(2), 2009.
// [10] D. Page, A. Koschan, S. Sukumar, B. Roui-Abidi, M. Abidi: Shape analysis algorithm based on information theory.
//      IEEE International Conference on Image Processing 2003.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "rendering/viewpoints/FocusImage.h"
#include "rendering/viewpoints/Placement.h"
#include "rendering/viewpoints/ViewChannel.h"

namespace fenestra::placement {

/// Each with its unit, its range, and whether high or low values are best. Logarithms are to base 2.
enum class ViewDescriptor : std::uint8_t {
  /// H(Z|v) = −Σ_z p(z|v) log p(z|v) [1, 2]; bit, from 0 to log n; high.
  Entropy,
  /// H(Z|v) with the labels in focus as elements z [2]; bit, from 0 to the logarithm of their number; high. A focus of
  /// one structure has no such value.
  StructureEntropy,
  /// I(v;Z) = Σ_z p(z|v) log(p(z|v) / p(z)) [3]; bit, from 0; low.
  MutualInformation,
  /// I2(v;Z) = H(Z) − H(Z|v) [4, 5]; bit, may be negative; low. It orders views as Entropy does, reversed.
  I2,
  /// 1 − the mean Jensen–Shannon divergence of p(Z|v) and p(Z|w), weighted by p(v) and p(w), over those of the 8
  /// directions w nearest to v that see the focus: 1 − the unstability of [6]; without unit, 0 to 1; high.
  Stability,
  /// Entropy of the histogram of the focus's depths in v's image, of 32 bins over its bounding sphere; bit, 0 to 5;
  /// high. [7] takes 1 − Σ h² of such a histogram.
  DepthDistribution,
  /// Length of the outline in v's image, over the model's diameter [7, 8]; without unit, from 0; high.
  SilhouetteLength,
  /// ∫ |κ| ds along that outline [7, 9], smoothed by 1/32 of the bounding sphere's diameter (turningOf() in
  /// FocusImage.h); radians, from 0, 2π for one convex outline; high.
  SilhouetteCurvature,
  /// Entropy of the classes of Gaussian curvature (SurfaceCurvature.h) of the points that v sees [8, 10]; bit, from 0;
  /// high.
  CurvatureEntropy
};
struct ViewDescriptorEntry {
  ViewDescriptor descriptor;
  std::string_view name, unit;
  bool isHighBest;
  bool needsImages;  ///< of the candidates; the others need the surface points that they see
};
/// All of them, in the order of the enumeration.
std::span<const ViewDescriptorEntry> viewDescriptors();
const ViewDescriptorEntry& entryOf(ViewDescriptor descriptor);

/// The focus's surface as points of equal area.
struct SurfacePoints {
  std::vector<glm::dvec3> positions;  ///< world, mm
  std::vector<glm::dvec3> normals;    ///< unit, world, out of the focus
  std::vector<std::uint16_t> labels;  ///< of each point, 0 where it has none; or empty
  double area = 0.0;                  ///< mm², of all
};

/// What a candidate's image gives; NaN where it does not see the focus.
struct ImageMeasures {
  double depthDistribution = 0.0, silhouetteLength = 0.0, silhouetteCurvature = 0.0;
};
/// `nearest` and `farthest` bound the focus's depths, `diameter` is the model's; all mm.
ImageMeasures measuresOf(const FocusImage& image, double nearest, double farthest, double diameter);

/// The candidates of one focus as the descriptors see them. All values are deterministic.
class DescribedViews {
 public:
  /// `candidates` are spread evenly; their `seen` has a bit for each of the surface's points. `images` has an entry for
  /// each candidate, or is empty where none was measured.
  DescribedViews(const std::vector<Candidate>& candidates, SurfacePoints surface, std::vector<ImageMeasures> images);

  /// For each candidate; NaN where it sees nothing of the focus, and where there is no value: with fewer than two
  /// labels for the structures' entropy, and without images.
  std::vector<double> values(ViewDescriptor descriptor) const;
  /// Share of the surface's points that each candidate sees.
  const std::vector<double>& shares() const { return shares_; }
  const ViewChannel& channel() const { return channel_; }

 private:
  std::vector<double> stability() const;
  std::vector<double> structureEntropy() const;
  std::vector<double> curvatureEntropy() const;

  std::vector<glm::dvec3> directions_;
  SurfacePoints surface_;
  std::vector<ImageMeasures> images_;
  std::vector<double> shares_;
  ViewChannel channel_;
};

/// The candidate that a descriptor would choose by its values, ties to the lowest index; empty where all are NaN.
std::optional<std::size_t> choiceBy(ViewDescriptor descriptor, const std::vector<double>& values);
/// Rank correlation of what a descriptor prefers by its values with a list of one value for each candidate: positive
/// where the views that it prefers have greater values there.
double preferenceCorrelation(ViewDescriptor descriptor, const std::vector<double>& values,
                             const std::vector<double>& with);

}  // namespace fenestra::placement
