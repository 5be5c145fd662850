(3: P0001 N001: #64 kann nur gelesen werden, richtig: #00..#63, #69. Anderen Parameter nehmen.)
P0001
N001 \10#64#01
