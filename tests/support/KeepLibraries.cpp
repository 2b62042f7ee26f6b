// Linked into programs that sanitizers watch: libraries stay loaded until the end, so that LeakSanitizer finds the
// names in them that lists of suppressions such as tests/gui/leaks.txt hold.

extern "C" int dlclose(void*) noexcept { return 0; }
