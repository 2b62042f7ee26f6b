#pragma once
// Which objects are proposed and accepted, and how they may be packed. Private to io/archive.

#include <set>
#include <string>
#include <vector>

#include "io/archive/Association.h"

namespace fenestra::io::archive {

/// UIDs of transfer syntaxes: those that every program writes, and those of packed pixels that io/dicom reads.
const std::vector<std::string>& plainSyntaxes();
const std::vector<std::string>& packedSyntaxes();

/// Contexts in which a server can send objects of these classes as it stores them: a context holds one packing, so that
/// no object is repacked for another's sake. With no class known, those of all images; at most 128.
std::vector<Context> receivingContexts(const std::set<std::string>& classes);

}  // namespace fenestra::io::archive
