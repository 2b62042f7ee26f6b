#pragma once
// The focus and the camera that a built-in phantom opens with: structures behind others, and a side that shows the
// cutaway well.

#include <string>
#include <vector>

#include "io/study/StudyRequest.h"

namespace fenestra::io {

struct PhantomView {
  std::vector<std::string> focus;  ///< names of labels
  ViewAngles camera;
};

inline PhantomView phantomView(const std::string& phantom) {
  if (phantom == "head") return {{"tumour", "ventricles"}, {50.0, 20.0}};
  return {{"heart muscle", "left ventricle", "right ventricle", "left atrium", "right atrium", "aorta", "left kidney",
           "right kidney", "lesion"},
          {25.0, 12.0}};
}

}  // namespace fenestra::io
