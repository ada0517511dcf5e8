// SPDX-License-Identifier: MIT
// The depth of a mesh without holes as the sun sees it. A program of its own, as one that may discard is drawn more slowly.
void main() {}
