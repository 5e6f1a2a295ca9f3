// A white wall that only a glowing one lights: Meniscus has no light of second hand.
// pixel 40, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 radiosity { count 400 error_bound 0.1 recursion_limit 1 } }
camera { location -5*z look_at 0 right 4/3*x angle 30 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0.5 } }
plane { z, -10 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } no_image }
