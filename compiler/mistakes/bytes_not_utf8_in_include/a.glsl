
// Höhe
