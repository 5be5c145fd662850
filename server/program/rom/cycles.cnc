(THE PROGRAMS BEHIND G81 TO G86, as the control has them in ROM. One block per line; a comment behind a
block says what it does. N005 to N063 are common to all; each cycle's own part begins at N100.

Set by the call     #46 W   #58 X or R   #59 Y or D   #60 Z   #61 Q   #62 V   #63 H
Then                #00 0   #47 2R   #48 -X/2+R   #49 -Y/2+R   #50 Z-0.5   #51 Q-0.5   #52 -V+0.5
                    #53 0.8 * 2R   #54 0.5   #55 #56 #57 place of the call   #58 X-2R   #59 Y-2R

Z, Q are negative. The surface lies V below the place of the call.)

(G81 DRILLING: as G82, called with Q = Z)
P9981
N005 \00 #00 +0.000      (#00 := 0)
N006 \00 #54 -0.500
N007 \10 #55 #64         (where the cycle was called: X, Y, Z)
N008 \10 #56 #65
N009 \10 #57 #66
N013 \13 #62 #62         (-V)
N020 \01 #50 #60 #54     (Z - 0.5: way from 0.5 above the surface to the depth)
N021 \01 #51 #61 #54     (Q - 0.5: way from 0.5 above the floor to the next floor)
N022 \02 #52 #62 #54     (-V + 0.5: rapid way from the safety distance to 0.5 above the surface)
N023 G91
N024 \13 #54 #54         (+0.5)
N030 \10 #47 #67
N031 \01 #47 #47 #67     (cutter diameter 2R)
N032 \02 #58 #58 #47     (X - 2R, at least 0)
N033 \51 N040
N034 \00 #58 +0.000
N040 \02 #59 #59 #47     (Y - 2R, at least 0)
N041 \51 N050
N042 \00 #59 +0.000
N050 \00 #53 +0.800
N051 \03 #53 #53 #47     (step between rows: 0.8 of the diameter)
N060 \03 #48 #58 #54
N061 \03 #49 #59 #54
N062 \13 #48 #48         (-X/2 + R)
N063 \13 #49 #49         (-Y/2 + R)
N100 \02 #60 #60 #61     (what is left below the coming cut, negative)
N101 G00 Z#52
N102 \50 N120            (nothing is left: last cut)
N103 \51 N120            (less than Q is left: last cut)
N104 G01 Z#51
N105 G90
N106 G00 Z#57            (out of the hole, D-81)
N107 G91
N108 \01 #52 #52 #61     (the next rapid way goes Q deeper)
N109 \53 N100
N120 \01 #60 #60 #51
N121 G01 Z#60            (to the depth)
N122 G04 H#63
N123 G90
N124 G45
N125 G00 Z#57
N126 G91
%

(G82 DEEP-HOLE DRILLING)
P9982
N005 \00 #00 +0.000      (#00 := 0)
N006 \00 #54 -0.500
N007 \10 #55 #64         (where the cycle was called: X, Y, Z)
N008 \10 #56 #65
N009 \10 #57 #66
N013 \13 #62 #62         (-V)
N020 \01 #50 #60 #54     (Z - 0.5: way from 0.5 above the surface to the depth)
N021 \01 #51 #61 #54     (Q - 0.5: way from 0.5 above the floor to the next floor)
N022 \02 #52 #62 #54     (-V + 0.5: rapid way from the safety distance to 0.5 above the surface)
N023 G91
N024 \13 #54 #54         (+0.5)
N030 \10 #47 #67
N031 \01 #47 #47 #67     (cutter diameter 2R)
N032 \02 #58 #58 #47     (X - 2R, at least 0)
N033 \51 N040
N034 \00 #58 +0.000
N040 \02 #59 #59 #47     (Y - 2R, at least 0)
N041 \51 N050
N042 \00 #59 +0.000
N050 \00 #53 +0.800
N051 \03 #53 #53 #47     (step between rows: 0.8 of the diameter)
N060 \03 #48 #58 #54
N061 \03 #49 #59 #54
N062 \13 #48 #48         (-X/2 + R)
N063 \13 #49 #49         (-Y/2 + R)
N100 \02 #60 #60 #61     (what is left below the coming cut, negative)
N101 G00 Z#52
N102 \50 N120            (nothing is left: last cut)
N103 \51 N120            (less than Q is left: last cut)
N104 G01 Z#51
N105 G90
N106 G00 Z#57            (out of the hole, D-81)
N107 G91
N108 \01 #52 #52 #61     (the next rapid way goes Q deeper)
N109 \53 N100
N120 \01 #60 #60 #51
N121 G01 Z#60            (to the depth)
N122 G04 H#63
N123 G90
N124 G45
N125 G00 Z#57
N126 G91
%

(G83 THREAD)
P9983
N005 \00 #00 +0.000      (#00 := 0)
N006 \00 #54 -0.500
N007 \10 #55 #64         (where the cycle was called: X, Y, Z)
N008 \10 #56 #65
N009 \10 #57 #66
N013 \13 #62 #62         (-V)
N020 \01 #50 #60 #54     (Z - 0.5: way from 0.5 above the surface to the depth)
N021 \01 #51 #61 #54     (Q - 0.5: way from 0.5 above the floor to the next floor)
N022 \02 #52 #62 #54     (-V + 0.5: rapid way from the safety distance to 0.5 above the surface)
N023 G91
N024 \13 #54 #54         (+0.5)
N030 \10 #47 #67
N031 \01 #47 #47 #67     (cutter diameter 2R)
N032 \02 #58 #58 #47     (X - 2R, at least 0)
N033 \51 N040
N034 \00 #58 +0.000
N040 \02 #59 #59 #47     (Y - 2R, at least 0)
N041 \51 N050
N042 \00 #59 +0.000
N050 \00 #53 +0.800
N051 \03 #53 #53 #47     (step between rows: 0.8 of the diameter)
N060 \03 #48 #58 #54
N061 \03 #49 #59 #54
N062 \13 #48 #48         (-X/2 + R)
N063 \13 #49 #49         (-Y/2 + R)
N100 G11 M03
N101 G00 Z#52
N102 G01 Z#50
N103 G11 M05
N104 G04 H#63
N105 G11 M04
N106 G90
N107 G01 Z#57            (out at the feed, spindle reversed)
N108 G11 M05
N109 G91
%

(G84 SLOT)
P9984
N005 \00 #00 +0.000      (#00 := 0)
N006 \00 #54 -0.500
N007 \10 #55 #64         (where the cycle was called: X, Y, Z)
N008 \10 #56 #65
N009 \10 #57 #66
N013 \13 #62 #62         (-V)
N020 \01 #50 #60 #54     (Z - 0.5: way from 0.5 above the surface to the depth)
N021 \01 #51 #61 #54     (Q - 0.5: way from 0.5 above the floor to the next floor)
N022 \02 #52 #62 #54     (-V + 0.5: rapid way from the safety distance to 0.5 above the surface)
N023 G91
N024 \13 #54 #54         (+0.5)
N030 \10 #47 #67
N031 \01 #47 #47 #67     (cutter diameter 2R)
N032 \02 #58 #58 #47     (X - 2R, at least 0)
N033 \51 N040
N034 \00 #58 +0.000
N040 \02 #59 #59 #47     (Y - 2R, at least 0)
N041 \51 N050
N042 \00 #59 +0.000
N050 \00 #53 +0.800
N051 \03 #53 #53 #47     (step between rows: 0.8 of the diameter)
N060 \03 #48 #58 #54
N061 \03 #49 #59 #54
N062 \13 #48 #48         (-X/2 + R)
N063 \13 #49 #49         (-Y/2 + R)
N100 G00 X#48 Y#49       (to the slot's start; the free axis has 0)
N101 \02 #60 #60 #61     (what is left below the coming pass, negative)
N102 G00 Z#52
N103 \50 N120            (nothing is left: last pass)
N104 \51 N120            (less than Q is left: last pass)
N105 G01 Z#51
N106 G01 X#58 Y#59       (along the slot)
N107 G90
N108 G00 Z#57
N109 G91
N110 \01 #52 #52 #61     (the next rapid way goes Q deeper)
N111 \13 #58 #58         (the next pass runs the other way)
N112 \13 #59 #59
N113 \53 N101
N120 \01 #60 #60 #51
N121 G01 Z#60            (to the depth)
N122 G01 X#58 Y#59
N123 G90
N124 G00 Z#57
N125 G00 X#55 Y#56       (back to the slot's centre)
N126 G91
%

(G85 POCKET)
P9985
N005 \00 #00 +0.000      (#00 := 0)
N006 \00 #54 -0.500
N007 \10 #55 #64         (where the cycle was called: X, Y, Z)
N008 \10 #56 #65
N009 \10 #57 #66
N013 \13 #62 #62         (-V)
N020 \01 #50 #60 #54     (Z - 0.5: way from 0.5 above the surface to the depth)
N021 \01 #51 #61 #54     (Q - 0.5: way from 0.5 above the floor to the next floor)
N022 \02 #52 #62 #54     (-V + 0.5: rapid way from the safety distance to 0.5 above the surface)
N023 G91
N024 \13 #54 #54         (+0.5)
N030 \10 #47 #67
N031 \01 #47 #47 #67     (cutter diameter 2R)
N032 \02 #58 #58 #47     (X - 2R, at least 0)
N033 \51 N040
N034 \00 #58 +0.000
N040 \02 #59 #59 #47     (Y - 2R, at least 0)
N041 \51 N050
N042 \00 #59 +0.000
N050 \00 #53 +0.800
N051 \03 #53 #53 #47     (step between rows: 0.8 of the diameter)
N060 \03 #48 #58 #54
N061 \03 #49 #59 #54
N062 \13 #48 #48         (-X/2 + R)
N063 \13 #49 #49         (-Y/2 + R)
N100 \01 #48 #48 #55     (the start point as a position)
N101 \01 #49 #49 #56
N102 G90                 (EVERY LAYER)
N103 G00 X#48 Y#49
N104 G91
N105 \02 #60 #60 #61     (what is left below the coming layer, negative)
N106 G00 Z#52
N107 \50 N111            (nothing is left: last layer)
N108 \51 N111            (less than Q is left: last layer)
N109 G01 Z#51
N110 \53 N113
N111 \01 #50 #60 #51     (#60 stays as it is and marks the last layer)
N112 G01 Z#50            (to the depth)
N113 G01 X#58            (THE FRAME)
N114 G01 Y#59
N115 \13 #58 #58
N116 \13 #59 #59
N117 G01 X#58
N118 G01 Y#59
N119 \13 #58 #58
N120 \13 #59 #59
N121 \02 #46 #58 #54     (length of a row: 0.5 less at either end)
N122 \02 #46 #46 #54
N123 \50 N150            (the frame has cleared it all)
N124 \52 N150
N125 \02 #47 #59 #54     (height of the rows: 0.5 less at either end)
N126 \02 #47 #47 #54
N127 \50 N150
N128 \52 N150
N129 G01 X#54 Y#54       (THE ROWS)
N130 G01 X#46
N131 \13 #46 #46         (the next row runs the other way)
N132 \02 #47 #47 #53
N133 \51 N140            (more is left than one step)
N134 \01 #47 #47 #53
N135 G01 Y#47            (the rest)
N136 G01 X#46
N137 \53 N150
N140 G01 Y#53
N141 \53 N130
N150 G90                 (OUT, AND THE NEXT LAYER)
N151 G00 Z#57
N152 G91
N153 \01 #52 #52 #61     (the next rapid way goes Q deeper)
N154 \01 #60 #60 #00     (puts what is left into the result register)
N155 \52 N102
N156 G90
N157 G00 X#55 Y#56       (back to the pocket's centre)
N158 G91
%

(G86 HOLE CIRCLE: without N030 to N063, which would overwrite #58 and #59)
P9986
N005 \00 #00 +0.000      (#00 := 0)
N006 \00 #54 -0.500
N007 \10 #55 #64         (where the cycle was called: X, Y, Z)
N008 \10 #56 #65
N009 \10 #57 #66
N013 \13 #62 #62         (-V)
N020 \01 #50 #60 #54     (Z - 0.5: way from 0.5 above the surface to the depth)
N021 \01 #51 #61 #54     (Q - 0.5: way from 0.5 above the floor to the next floor)
N022 \02 #52 #62 #54     (-V + 0.5: rapid way from the safety distance to 0.5 above the surface)
N023 G91
N024 \13 #54 #54         (+0.5)
N100 \00 #53 +360.000
N101 \04 #53 #53 #46     (angle between two holes)
N102 \17 #47 #59         (EVERY HOLE: its X ...)
N103 \03 #47 #47 #58
N104 \01 #47 #47 #55     (... as a position)
N105 \16 #48 #59         (its Y ...)
N106 \03 #48 #48 #58
N107 \01 #48 #48 #56     (... as a position)
N108 G90
N109 G00 X#47 Y#48
N110 G91
N111 \01 #60 #50 #54     (Z again for this hole)
N112 \01 #52 #62 #54     (-V + 0.5 again)
N120 \02 #60 #60 #61     (deep drilling as P9982, but the length compensation stays)
N121 G00 Z#52
N122 \50 N130
N123 \51 N130
N124 G01 Z#51
N125 G90
N126 G00 Z#57
N127 G91
N128 \01 #52 #52 #61
N129 \53 N120
N130 \01 #60 #60 #51
N131 G01 Z#60
N132 G04 H#63
N133 G90
N134 G00 Z#57
N135 G91
N140 \01 #59 #59 #53     (the next angle)
N141 \12 #46 #46         (holes left)
N142 \51 N102
N143 G90
N144 G00 X#55 Y#56       (back to the circle's centre)
N145 G91
%
