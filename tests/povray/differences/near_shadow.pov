// A leaf 5e-4 before a white wall: POV-Ray's shadow rays see nothing nearer than 1e-3.
// pixel 40, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 }
camera { location -5*z look_at 0 right 4/3*x angle 30 }
light_source { -9*z, rgb 1 parallel point_at 0 }
box { <-9, -9, 0>, <9, 9, 1> pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
box { <-1, -1, -6e-4>, <1, 1, -5e-4> pigment { rgb 1 } no_image }
