#pragma once
float one() { return two; }
