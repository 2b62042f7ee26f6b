#pragma once
// The members of a session in JSON: what readSession takes, writeSession writes and sessionSchema publishes. Private to
// io/session.

#include "io/base/Words.h"
#include "io/session/SceneJson.h"
#include "io/session/Session.h"

namespace fenestra {

using io::json::Is;

inline auto wordsOf(ScalarType) {
  std::vector<Word<ScalarType>> words;
  for (const ScalarType type : {ScalarType::UInt8, ScalarType::Int8, ScalarType::UInt16, ScalarType::Int16,
                                ScalarType::UInt32, ScalarType::Int32, ScalarType::Float32, ScalarType::Float64})
    words.push_back({type, nameOf(type)});
  return words;
}

inline auto wordsOf(MeasureKind) {
  return std::to_array<Word<MeasureKind>>({{MeasureKind::Distance, "distance"},
                                           {MeasureKind::Angle, "angle"},
                                           {MeasureKind::Ellipse, "ellipse"},
                                           {MeasureKind::Rectangle, "rectangle"},
                                           {MeasureKind::Arrow, "arrow"},
                                           {MeasureKind::Text, "text"}});
}

void members(auto& io, Is<Measure> auto& measure) {
  io.required("kind", measure.kind);
  io.required(
      "points", measure.points, millimetres,
      {"In the patient's mm (LPS). Distance: its ends; angle: end, vertex, end; ellipse and rectangle: opposite "
       "corners of the box around it; arrow: tip, end; text: where it begins"});
  io.required("right", measure.right, {-1.0, 1.0}, {"Unit vector along the rows of the slice that it lies on"});
  io.required("down", measure.down, {-1.0, 1.0}, {"Unit vector down the columns of that slice"});
  io.optional("text", measure.text, !measure.text.empty(), {}, {"Of an arrow or a text, at most 400 bytes of UTF-8"});
}

void members(auto& io, Is<PlaneAxes> auto& axes) {
  io.required("right", axes.right, {-1.0, 1.0}, {"Unit vector along the rows, in the patient (LPS)"});
  io.required("down", axes.down, {-1.0, 1.0}, {"Unit vector down the columns"});
  io.required("normal", axes.normal, {-1.0, 1.0}, {"Unit vector along which the slices are counted"});
}

void members(auto& io, Is<Slab> auto& slab) {
  io("thickness", slab.thickness, {0.0, fenestra::io::mostSlab},
     {"Half of it to each side of the slice; 0 is the slice alone", "mm"});
  io("mode", slab.mode, {}, {"What of the values along the normal shows"});
}

void members(auto& io, Is<OpeningView> auto& opening) {
  io.required("camera", opening.camera);
  io.required("size", opening.size, {1.0, 16384.0}, {"Of the picture that the opening was cut for", "pixels"});
  io("pixel_scale", opening.pixelScale, {0.01, 100.0}, {"Pixels per device-independent pixel"});
}

namespace placement {

void members(auto& io, Is<Weights> auto& weights) {
  io("visibility", weights.visibility);
  io("coverage", weights.coverage);
  io("location", weights.location);
  io("entropy", weights.entropy);
  io("mutual_information", weights.mutualInformation);
  io("stability", weights.stability);
  io("orientation", weights.orientation);
  io("end_face", weights.endFace);
}

void members(auto& io, Is<Habits> auto& habits) {
  io("avoid_cut_ends", habits.avoidCutEnds, {}, {"Not through an end of the scan where the body goes on"});
  io("upright_first", habits.uprightFirst, {}, {"From around the patient rather than from above or below"});
  io("flat_from_front", habits.flatFromFront, {}, {"A thin stack of slices from its front"});
  io("near_side_first", habits.nearSideFirst, {}, {"From the side of the body that the focus is nearer to"});
}

void members(auto& io, Is<LiveSyncWeights> auto& weights) {
  constexpr double most = 1000.0;
  io("orientation", weights.orientation, {0.0, most}, {"Of how usual a view is of a patient"});
  io("history", weights.history, {0.0, most}, {"Of its nearness to the last one"});
  io("shape", weights.shape, {0.0, most}, {"Of how much it shows of the structure's shape around the point"});
  io("visibility", weights.visibility, {0.0, most}, {"Of how little hides the structure there"});
}

}  // namespace placement

namespace io {

inline constexpr const char* sessionFormat = "fenestra-session";
inline constexpr double largestPicture = 16384.0;  ///< pixels a side, what OpenGL 4.5 drivers commonly offer

void members(auto& io, Is<RawDescription> auto& raw) {
  io.required("dims", raw.dims, {1.0, 1e6});
  io.required("type", raw.type);
  io("big_endian", raw.bigEndian);
  io("skip", raw.skip, {}, {"Bytes before the first voxel"});
  io("spacing", raw.spacing, positiveMillimetres, {"Between voxel centres", "mm"});
}

void members(auto& io, Is<SessionData> auto& data) {
  const bool known = !data.contents.hash.empty();
  io.required("path", data.path);
  io.optional(
      "contents", data.contents.hash, known, {},
      {"sha256:HEX. Of one file, its SHA-256; of several, that of their sorted hashes in hexadecimal, a line each"});
  io.optional("bytes", data.contents.bytes, known, {}, {"Size of all files together"});
  io.optional("files", data.contents.files, known, {}, {"Number of files"});
}

/// The members that `data` has of its base.
void baseMembers(auto& io, auto& data) {
  members(io, static_cast<std::conditional_t<std::is_const_v<std::remove_reference_t<decltype(data)>>,
                                             const SessionData, SessionData>&>(data));
}

void members(auto& io, Is<SessionLabels> auto& labels) {
  baseMembers(io, labels);
  io.optional("table", labels.table, !labels.table.empty(), {},
              {"A table of names and colours in place of the label map's own"});
}

void members(auto& io, Is<SessionVolume> auto& volume) {
  baseMembers(io, volume);
  io.optional("series", volume.series, !volume.series.empty(), {},
              {"sha256:HEX of the series' id as fenestra-cli info gives it; the id itself leads to the patient"});
  io.optional("time", volume.time, volume.time != 1, {1.0, 1e6}, {"Time point, from 1, of a file that holds several"});
  io.optional("raw", volume.raw, volume.raw.has_value(), {}, {"How the bytes of a file without a header are read"});
  io.optional("spacing", volume.spacing, volume.spacing.has_value(), positiveMillimetres,
              {"Between voxel centres, told for a file that does not say it", "mm"});
  io.optional("regularise", volume.regularise, volume.regularise != Regularise::Automatic, {},
              {"Whether slices that lie unevenly or askew are resampled onto even planes"});
  io.optional("modality", volume.modality, volume.modality.has_value(), {},
              {"What the volume was told to be or recognised as, where its file does not say"});
}

void members(auto& io, Is<SessionPhantom> auto& phantom) {
  io.required("name", phantom.name);
  io("voxels", phantom.voxels, {1.0, 1024.0}, {"Along its longest side"});
}

void members(auto& io, Is<SessionView> auto& view) {
  io.required("camera", view.camera);
  io("size", view.size, {1.0, largestPicture}, {"Of the picture", "pixels"});
  io("pixel_scale", view.pixelScale, {0.01, 100.0}, {"Pixels per device-independent pixel"});
  io("fits_width", view.fitsWidth, {},
     {"Whether the field of view is widened in a picture higher than wide, so that it shows what a square one does"});
  io.optional("frozen", view.frozen, view.frozen.has_value(), {},
              {"The opening stays cut for this camera while the view's own moves"});
}

void members(auto& io, Is<SessionPlacement> auto& placement) {
  io("samples", placement.samples, {12.0, 12288.0}, {"Directions to try"});
  io("refined", placement.refined, {}, {"Whether the best directions are refined"});
  io("weights", placement.weights);
  io("habits", placement.habits);
  io("in_stream", placement.inStream, {},
     {"Whether C2 lies in the band around C1's great circle instead of the half sphere"});
  io("stream_half_width", placement.streamHalfWidth, {0.0, 90.0}, {"Of that band", "degrees"});
  io("share_weight", placement.shareWeight, fraction,
     {"Joint search: 1 weighs the share of the surface alone, 0 the "
      "mean quality alone"});
  io("joint", placement.joint, {}, {"Whether both cameras are searched together"});
  io("follow", placement.follow, {}, {"Whether C2 goes to the best of its region when C1 is turned"});
  io("automatic", placement.automatic, {}, {"Whether cameras are placed when a focus is chosen"});
  io("by_pick", placement.byPick, {}, {"Whether they are placed for points clicked on slices instead (LiveSync)"});
  io("pick_weights", placement.liveSync.weights);
  io("pick_reach", placement.liveSync.reach, {1.0, 1000.0}, {"How far from such a point its structure counts", "mm"});
}

inline auto wordsOf(PlaneFollow) {
  return std::to_array<Word<PlaneFollow>>(
      {{PlaneFollow::None, "none"}, {PlaneFollow::C1, "C1"}, {PlaneFollow::C2, "C2"}});
}

void members(auto& io, Is<SessionPlane> auto& plane) {
  io.optional("axes", plane.axes, plane.axes.has_value(), {},
              {"Where it is turned: perpendicular unit vectors; its slices pass through the crosshair"});
  io("follow", plane.follow, {}, {"The camera that it faces, as that turns"});
  io("slab", plane.slab, {}, {"How thick its slices are"});
}

void members(auto& io, Is<SessionOverlays> auto& overlays) {
  io("crosshair", overlays.crosshair);
  io("text", overlays.text);
  io("labels", overlays.labels);
  io("measures", overlays.measures);
  io("planes", overlays.planes, {}, {"The slices' outlines in the 3-D views"});
}

void members(auto& io, Is<KeyView> auto& view) {
  io.required("camera", view.camera);
  io.optional("frozen", view.frozen, view.frozen.has_value(), {}, {"As in the session's views"});
}

void members(auto& io, Is<KeyImage> auto& image) {
  io.required("name", image.name);
  io.optional("picture", image.picture, !image.picture.empty(), {}, {"A small picture: PNG in Base64"});
  io.required("views", image.views, {}, {"C1 and C2"});
  io.required("window", image.window, {}, {"Display window of the slices"});
  io("inverted", image.inverted, {}, {"Whether the slices show low values bright"});
  io.required("crosshair", image.crosshair, millimetres);
  io("planes", image.planes, {}, {"How the axial, sagittal and coronal slices lie"});
  io.required("look", image.look, {}, {"What a session says of the focus, labels, transfer function and opening"});
}

void members(auto& io, Is<Session> auto& session) {
  io.optional("volume", session.volume, !session.volume.path.empty());
  io.optional("phantom", session.phantom, session.phantom.has_value(), {}, {"A built-in phantom in place of a volume"});
  io.optional("labels", session.labels, !session.labels.path.empty(), {}, {"The label map"});
  members(io, session.look);
  io("quality", session.quality);
  io.optional("max_error", session.maxError, session.maxError.has_value(), maxErrors,
              {"Greatest error of a pixel's colour; takes the place of quality", "1/255"});
  io.required("views", session.views, {}, {"C1 and C2: the camera, and the picture that was seen there"});
  io("home", session.home, {}, {"Where resetting the views takes C1 and C2"});
  io("linked", session.linked, {}, {"Whether turning one camera turns the other"});
  io.optional("window", session.window, session.window.has_value(), {},
              {"Display window of the slices; without it, the data's own"});
  io("inverted", session.inverted, {}, {"Whether the slices show low values bright"});
  io.optional("crosshair", session.crosshair, session.crosshair.has_value(), millimetres);
  io("overlays", session.overlays, {}, {"What is drawn over the pictures"});
  io("planes", session.planes, {}, {"How the axial, sagittal and coronal slices lie"});
  io("measures", session.measures, {}, {"Distances, angles, regions, arrows and texts on the slices"});
  io.optional("path", session.path, !session.path.empty(), millimetres,
              {"Points that the straightened picture follows, at least two, in the patient's mm (LPS)"});
  io.optional("follows_path", session.followsPath, session.followsPath, {},
              {"Whether both cameras go along the path with its place"});
  io.optional("key_images", session.keyImages, !session.keyImages.empty(), {},
              {"States of the window that one returns to, in the user's order"});
  io.optional("maximised", session.maximised, !session.maximised.empty(), {},
              {"The view that has the whole area: C1, C2, axial, sagittal or coronal"});
  io.optional("layout", session.layout, !session.layout.empty(), {},
              {"The window's own, in Base64; means nothing to others"});
  io("placement", session.placement, {}, {"How cameras are placed for the focus; see fenestra-cli place --help"});
  io.optional("autosave_of", session.autosaveOf, !session.autosaveOf.empty(), {},
              {"In a copy saved in case of a crash: the session that it is ahead of"});
}

}  // namespace io
}  // namespace fenestra
