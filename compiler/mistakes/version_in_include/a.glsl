// A module.
#version 450
