// What this shader will do:
/* everything */
