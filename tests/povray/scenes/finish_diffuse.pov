// expect rmse 1e-5: rounding to 16 bits is 4.4e-6
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 adc_bailout 1e-4 }
camera { location <0.3, 1.6, -5> look_at <0, 0.6, 0> right x*image_width/image_height angle 40 }
light_source { <4, 6, -5> rgb 0.8 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.7, 0.6> rgb <0.2, 0.3, 0.4> scale 0.5 } finish { ambient 0.1 diffuse 0.6 } }
sphere { <-1.4, 0.45, 0>, 0.42 pigment { rgb <0.9, 0.6, 0.3> } finish { ambient 0.3 diffuse 0.4 } }
sphere { <-0.45, 0.45, 0>, 0.42 pigment { rgb <0.9, 0.6, 0.3> } finish { diffuse 0.8 brilliance 2 } }
sphere { <0.5, 0.45, 0>, 0.42 pigment { rgb <0.9, 0.6, 0.3> } finish { emission 0.3 diffuse 0.2 } }
sphere { <1.45, 0.45, 0>, 0.42 pigment { rgb <0.9, 0.6, 0.3> } finish { ambient 0 } }
sphere { <-1.4, 1.4, 0>, 0.42 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.6 } }
sphere { <-0.45, 1.4, 0>, 0.42 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.6 phong_size 5 metallic } }
sphere { <0.5, 1.4, 0>, 0.42 pigment { rgb <0.9, 0.6, 0.3> } finish { specular 0.5 roughness 0.1 } }
sphere { <1.45, 1.4, 0>, 0.42 pigment { rgb <0.9, 0.6, 0.3> } finish { specular 0.4 metallic 0.5 } }
