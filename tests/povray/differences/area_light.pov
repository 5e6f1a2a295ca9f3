// A wall under an area_light of two by two lamps, of which a screen hides one row: Meniscus has a point light in their middle.
// pixel 40, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 }
camera { location -5*z look_at 0 right 4/3*x angle 30 }
light_source { -100*z, rgb 1 area_light 8*x, 8*y, 2, 2 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
box { <-9, 0.1, -51>, <9, 9, -50> pigment { rgb 0 } }
