// expect rmse 1e-5: rounding to 16 bits is 4.4e-6
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 adc_bailout 1e-4 }
camera { location <0.3, 1.6, -5> look_at <0, 0.6, 0> right x*image_width/image_height angle 40 }
light_source { <4, 6, -5> rgb 0.8 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.7, 0.6> rgb <0.2, 0.3, 0.4> scale 0.5 } finish { ambient 0.1 diffuse 0.6 } }
cylinder { <-1.5, 0, 0>, <-1.2, 0.9, 0.2>, 0.3 pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } }
cone { <-0.5, 0, 0>, 0.45, <-0.5, 1, 0>, 0.1 pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } }
torus { 0.4, 0.15 rotate 60*x translate <0.5, 0.5, 0> pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } }
disc { <1.4, 0.6, 0>, <0.3, 0.5, -1>, 0.5, 0.2 pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } }
polygon { 10, <-1.6, 1.2, 0.5>, <-0.6, 1.2, 0.5>, <-0.6, 1.9, 0.5>, <-1.6, 1.9, 0.5>, <-1.6, 1.2, 0.5>, <-1.3, 1.4, 0.5>, <-0.9, 1.4, 0.5>, <-0.9, 1.7, 0.5>, <-1.3, 1.7, 0.5>, <-1.3, 1.4, 0.5> pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } }
triangle { <0, 1.2, 0.5>, <0.8, 1.2, 0.5>, <0.4, 1.9, 0.2> pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } }
smooth_triangle { <1, 1.2, 0.5>, <-0.5, 0, -1>, <1.8, 1.2, 0.5>, <0.5, 0, -1>, <1.4, 1.9, 0.2>, <0, 0.5, -1> pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } }
