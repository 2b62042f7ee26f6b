#pragma once
// Completion of a program's options in bash, zsh and fish, made from the options themselves.

#include "app/options/Options.h"

namespace fenestra::app {

/// Adds --completion SHELL to the program: parsing then prints the shell's script to standard output and ends the
/// program. The script knows all commands and options that `program` has by then; an option completes with the
/// words of its type name (`on|off`), with files where that says FILE or PATH, and with folders where it says FOLDER.
void addCompletionOption(Program& program);

}  // namespace fenestra::app
